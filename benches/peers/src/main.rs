//! dev
mod crates; mod hand; mod ours; mod reference; mod row; mod scene;
use row::*;
fn main() {
    let reference = reference::Reference::new();
    const S: &[u32] = &[1,2,5,10,20,50,100];
    let mut rows = vec![Compiled{origin:Origin::Ours,method:"exact",setting:Setting::None,run:Box::new(|p|ours::exact(p).unwrap())}];
    rows.extend(stepped(Origin::Ours,"rk4 gen",S,|p,n|ours::runge_kutta_4(p,n).unwrap()));
    rows.extend(stepped(Origin::Hand,"rk4 hand",S,hand::runge_kutta_4));
    rows.extend(adaptive(Origin::Hand,"dp5 hand",hand::dormand_prince));
    rows.extend(crates::rows());
    let mut base=0.0;
    for r in rows {
        let mut p=[0.0;201];
        (r.run)(&mut p);
        let e=reference.error(&p);
        let mut best=f64::INFINITY;
        for _ in 0..15 { let t=std::time::Instant::now(); let mut n=0; while t.elapsed().as_micros()<1500 {(r.run)(std::hint::black_box(&mut p));n+=1;} best=best.min(t.elapsed().as_nanos() as f64/(2*n) as f64);}
        if base==0.0 {base=best}
        println!("{:40} {:10} {:9.1e} {:10.0} {:8.1}", r.method, r.setting.to_string(), e, best, best/base);
    }
}
