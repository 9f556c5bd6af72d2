//! One test for each hard case of the catalogue that `lyapunov hard` prints. A test target of `lyapunov-lab`.
//!
//! `hard_cases.csv` is the `hard.csv` of `lyapunov hard --out`, as it was when the cases were last looked at.

use lyapunov_lab::hard::{Catalogue, Verdicts};

#[track_caller]
fn passes(name: &str) {
    let cases = Catalogue::cases();
    let case = cases.iter().find(|case| case.name == name).expect("a case of this name");
    let row = case.row().expect("a run");
    assert!(row.passed, "{row:#?}");
    // The bound is judged here without `passed`.
    assert!(row.measured.is_finite() && row.measured <= row.bound, "{row:#?}");
    assert!(row.largest_force_n.is_finite() && row.ledger_off <= 1.0, "{row:#?}");
    assert!(row.verdict != Verdicts::default(), "nothing ran: {row:#?}");
    // A bound says nothing of a case that measures less than it did.
    let alone = Catalogue { stabilizer: None, rows: vec![row] }.csv();
    let line = alone.lines().nth(1).expect("a row");
    let kept = include_str!("hard_cases.csv");
    assert!(kept.lines().any(|it| it == line), "not in hard_cases.csv: {line}");
}

macro_rules! cases {
    ($($test:ident: $name:literal),+ $(,)?) => {
        $(
            #[test]
            fn $test() {
                passes($name);
            }
        )+

        /// Every case of the catalogue has a test here.
        #[test]
        fn every_case_has_a_test() {
            let names: Vec<_> = Catalogue::cases().iter().map(|case| case.name).collect();
            assert_eq!(names, [$($name),+]);
        }
    };
}

cases! {
    a_debt_at_rest: "a debt at rest",
    a_debt_at_a_subnormal_velocity: "a debt at a subnormal velocity",
    a_square_of_0: "a square of 0",
    a_subnormal_square: "a subnormal square",
    forces_and_velocities_of_1e150: "forces and velocities of 1e150",
    forces_and_velocities_of_1e_150: "forces and velocities of 1e-150",
    forces_of_1e150_at_1e_150: "forces of 1e150 at 1e-150 m/s",
    nan_once: "NaN once",
    infinity_once: "infinity once",
    nan_from_then_on: "NaN from then on",
    infinity_from_then_on: "infinity from then on",
    nan_once_with_a_credit: "NaN once, with a credit",
    nan_once_behind_a_guard: "NaN once, behind a guard",
    a_stale_sample: "a stale sample",
    a_stale_sample_work: "a stale sample: work",
    a_sample_twice: "a sample twice",
    a_sample_twice_work: "a sample twice: work",
    a_dropped_sample: "a dropped sample",
    a_dropped_sample_work: "a dropped sample: work",
    a_late_sample: "a late sample",
    a_late_sample_work: "a late sample: work",
    many_ticks: "1e8 ticks",
    an_hour_at_10_khz_in_f32: "an hour at 10 kHz in f32",
    time_stamps_after_1e9_s: "time stamps after 1e9 s",
    a_meganewton_per_metre_at_1_khz: "1e6 N/m at 1 kHz",
    fifty_kilonewtons_per_metre_at_100_hz: "5e4 N/m at 100 Hz",
    a_hand_a_million_times_the_device: "a hand 1e6 times the device",
    a_device_a_million_times_the_hand: "a device 1e6 times the hand",
    grazing_contact: "grazing contact",
    endless_small_bounces: "endless small bounces",
    encoder_chatter_at_rest: "encoder chatter at rest",
    two_walls_facing_each_other: "two walls facing each other",
    one_tick_of_delay: "1 tick of delay",
    two_ticks_of_delay: "2 ticks of delay",
    three_ticks_of_delay: "3 ticks of delay",
    four_ticks_of_delay: "4 ticks of delay",
    five_ticks_of_delay: "5 ticks of delay",
    a_cap_of_0: "a cap of 0",
    a_cap_of_one: "a cap of m / T",
    a_cap_of_two: "a cap of 2 m / T",
    an_active_environment: "an active environment",
    a_spring_that_pumps: "a spring that pumps",
    a_credit_larger_than_what_burns: "a credit larger than what burns",
    the_same_credit_taken: "the same credit, taken",
    a_jittered_period: "a jittered period",
    saturation_below_the_wall: "saturation below the wall",
    masking_a_sum_for_each_axis: "masking: a sum for each axis",
    masking_one_sum: "masking: one sum",
    masses_over_12_decades: "masses over 12 decades",
    periods_over_12_decades: "periods over 12 decades",
    found_a_stiff_wall_two_ticks_late: "a stiff wall, two ticks late",
    found_a_fifth_of_the_answers_lost: "a fifth of the answers lost",
    found_works_of_femtojoules: "works of femtojoules",
}
