//! Rest of the wave-variable teleoperator in closed form.

use crate::teleoperation::shipped::{compared, parsed, scores, text};
use approx::abs_diff_eq;

/// At rest hand, link, coordination and wall are springs in series. The link's spring is that of a line: a wave takes
/// `2 d + 1` ticks there and back, during which `b` carries the force, so the link yields by `(2 d + 1) T / (2 b)`
/// metres per newton.
#[test]
fn waves_rest_where_springs_in_series_do() {
    for delay in [0, 1, 20, 50] {
        let text = text("constant-delay")
            .replace("delay = 20", &format!("delay = {delay}"))
            .replace("duration = 5.0", "duration = 20.0");
        let [none, .., waves] = scores(&compared(&parsed(&text)));
        let line = f64::from(2 * delay + 1) * 1e-3 / (2.0 * 2.0);
        let (hand, coordination, wall) = (1.0 / 100.0, 1.0 / 200.0, 1.0 / 2000.0);
        let force = 0.005 / (hand + line + coordination + wall);
        let is = |name: &str, told: Option<f64>, expected: f64| {
            let told = told.unwrap();
            assert!(
                abs_diff_eq!(told, expected, epsilon = 2e-3),
                "{name} at {delay}: {told} mm, not {expected}"
            );
        };
        is("drift", waves.drift, -1e3 * force * line);
        is("error", waves.error_end, 1e3 * force * (line + coordination));
        assert!(waves.verdict.is_bounded() && waves.speed.unwrap() < 1e-3, "{waves:?}");
        if delay == 0 {
            let force = 0.005 / (hand + coordination + wall);
            is("drift without waves", none.drift, 0.0);
            is("error without waves", none.error_end, 1e3 * force * coordination);
        }
    }
}
