//! Runge-Kutta method of order 4, by hand.

use crate::scene::{PERIOD, Positions, rate, rollout};

/// Classical Runge-Kutta method (Kutta 1901) for `ẍ = a(x, ẋ, f)`, with the slopes of the position substituted.
#[inline(never)]
pub(crate) fn runge_kutta_4(positions: &mut Positions, steps: u32) {
    let step = PERIOD / f64::from(steps);
    let (half, sixth) = (0.5 * step, step * (1.0 / 6.0));
    rollout(positions, |[mut x, mut v], force| {
        let acceleration = |x, v| rate([x, v], force)[1];
        for _ in 0..steps {
            let a1 = acceleration(x, v);
            let v2 = v + half * a1;
            let a2 = acceleration(x + half * v, v2);
            let v3 = v + half * a2;
            let a3 = acceleration(x + half * v2, v3);
            let v4 = v + step * a3;
            let a4 = acceleration(x + step * v3, v4);
            let inner = a2 + a3;
            x += step * (v + sixth * (a1 + inner));
            v += sixth * (a1 + inner + inner + a4);
        }
        [x, v]
    });
}
