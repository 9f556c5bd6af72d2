//! Rest of teleoperators in closed form.

use crate::teleoperation::shipped::{compared, parsed, scores, text};
use approx::{abs_diff_eq, assert_abs_diff_eq};

/// At rest hand, link, coordination and wall are springs in series. The link's spring is that of a line: a wave takes
/// `2 d + 1` ticks there and back and its filter `τ` each way, during which `b` carries the force, so the link yields by
/// `((2 d + 1) T + 2 τ) / (2 b)` metres per newton. The other links do not yield.
#[test]
fn links_rest_where_springs_in_series_do() {
    for delay in [0, 1, 20, 50] {
        let text = text("constant-delay")
            .replace("delay = 20", &format!("delay = {delay}"))
            .replace("impedance = 8.0", "impedance = 8.0\nwave-variables.filter_time = 0.005")
            .replace("duration = 5.0", "duration = 20.0");
        let [none, _, _, _, layers, waves, matched, filtered] = scores(&compared(&parsed(&text)));
        let trip = f64::from(2 * delay + 1) * 1e-3;
        let unfiltered = trip / (2.0 * 8.0);
        let mut rows = vec![
            (layers, 0.0),
            (waves, unfiltered),
            (matched, unfiltered),
            (filtered, (trip + 2.0 * 0.005) / (2.0 * 8.0)),
        ];
        if delay == 0 {
            rows.push((none, 0.0));
        }
        let (hand, coordination, wall) = (1.0 / 100.0, 1.0 / 200.0, 1.0 / 2000.0);
        for (row, line) in rows {
            let force = 0.005 / (hand + line + coordination + wall);
            let is = |name: &str, told: Option<f64>, expected: f64| {
                let (told, of) = (told.unwrap(), row.stabilizer);
                let near = abs_diff_eq!(told, expected, epsilon = 2e-3);
                assert!(near, "{name} of {of} at {delay}: {told}, not {expected}");
            };
            is("drift, mm,", row.drift, -1e3 * force * line);
            is("error, mm,", row.error_end, 1e3 * force * (line + coordination));
            is("force, N,", row.felt_end, force);
            assert!(row.verdict.is_bounded() && row.speed.unwrap() < 1e-3, "{row:?}");
        }
    }
}

/// What hand, coordination and wall hold in series without a link between them.
#[test]
fn an_ideal_link_does_not_yield() {
    let file = parsed(&text("constant-delay"));
    let force = 0.005 / (1.0 / 100.0 + 1.0 / 200.0 + 1.0 / 2000.0);
    assert_abs_diff_eq!(file.ideal_force(), force, epsilon = 1e-15);
    for beyond in ["position = 0.005", "position = 0"] {
        let text = text("constant-delay").replace("position = -0.005", beyond);
        assert_eq!(parsed(&text).ideal_force(), 0.0);
    }
    let free =
        text("constant-delay").replace("wall = { stiffness = 2000.0, position = -0.005 }", "");
    assert_eq!(parsed(&free).ideal_force(), 0.0);
}
