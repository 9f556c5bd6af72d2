use std::hint::black_box;
use std::time::Instant;
use lyapunov::*;
const HAND: Impedance<f64> = Impedance { mass: 0.1+0.2, damping: 0.201, stiffness: 50.0 };
fn best(name:&str, per:f64, mut f: impl FnMut()) { let mut b=f64::INFINITY; for _ in 0..40 { let t=Instant::now(); for _ in 0..500 { f() } b=b.min(t.elapsed().as_nanos() as f64/500.0); } println!("{name:30} {:.2} ns", b/per); }
#[inline(never)] fn hand_div(p:&mut [f64;201], m:&[[f64;3];2]) { let (mut x,mut v,mut b)=(-0.004,0.0,-0.004); p[0]=x; for at in &mut p[1..] { let vel=(x-b)/0.01; let f=8000.0*x+2.0*vel; let f= if x>0.0&&f>0.0 {f} else {0.0}; b=x; let nx = x+(m[0][0]*x+m[0][1]*v+m[0][2]*f); v=v+(m[1][0]*x+m[1][1]*v+m[1][2]*f); x=nx; *at=x; } }
#[inline(never)] fn hand_own(p:&mut [f64;201], m:&[[f64;3];2]) { let (mut x,mut v)=(-0.004,0.0); p[0]=x; for at in &mut p[1..] { let f=8000.0*x+2.0*v; let f= if x>0.0&&f>0.0 {f} else {0.0}; let nx = x+(m[0][0]*x+m[0][1]*v+m[0][2]*f); v=v+(m[1][0]*x+m[1][1]*v+m[1][2]*f); x=nx; *at=x; } }
#[inline(never)] fn typed(p:&mut [f64;201], mut plant: Body<f64>) { let mut port=Wall::new(8000.0,2.0).unwrap().differenced(); let mut d=plant.start(); p[0]=d.position; for at in &mut p[1..] { d=plant.advance(port.respond(&d)); *at=d.position; } }
#[inline(never)] fn typed_own(p:&mut [f64;201], mut plant: Body<f64>) { let mut port=Wall::new(8000.0,2.0).unwrap(); let mut d=plant.start(); p[0]=d.position; for at in &mut p[1..] { d=plant.advance(port.respond(&d)); *at=d.position; } }
#[inline(never)] fn make(h: Impedance<f64>) -> Body<f64> { Body::new(h, 0.01).unwrap().starting(-0.004, 0.0) }
fn main() {
    // clock: a chain of 1000 adds of 1 cycle integer
    best("1000 dependent imul (3 cycles)", 3000.0, || { let mut x=black_box(3u64); for _ in 0..1000 { x = black_box(7u64).wrapping_mul(x) ^ 0; } black_box(x); });
    best("add chain", 1000.0, || { let mut x=black_box(3.0f64); let y=black_box(1.0); for _ in 0..1000 { x=x+y; } black_box(x); });
    best("mul chain", 1000.0, || { let mut x=black_box(3.0f64); let y=black_box(1.0000001); for _ in 0..1000 { x=x*y; } black_box(x); });
    best("div chain", 1000.0, || { let mut x=black_box(3.0f64); let y=black_box(1.0000001); for _ in 0..1000 { x=x/y; } black_box(x); });
    best("Body::new", 1.0, || { black_box(make(black_box(HAND))); });
    let body = make(HAND);
    let mut p=[0.0;201];
    best("typed loop per sample", 200.0, || typed(black_box(&mut p), black_box(body)));
    best("typed loop own velocity", 200.0, || typed_own(black_box(&mut p), black_box(body)));
    let h = held_input(nalgebra::Matrix3::new(0.,1.,0.,-50./0.3,-0.201/0.3,-1./0.3,0.,0.,0.)*0.01);
    let m=[[h[(0,0)],h[(0,1)],h[(0,2)]],[h[(1,0)],h[(1,1)],h[(1,2)]]];
    best("hand div", 200.0, || hand_div(black_box(&mut p), black_box(&m)));
    best("hand own velocity", 200.0, || hand_own(black_box(&mut p), black_box(&m)));
}
