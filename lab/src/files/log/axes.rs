//! Axes of a log beside the one that is read.

use super::columns::Role;
use super::heading::Heading;
use crate::text::shorten;

/// The axes of a space, by the names of position and force.
const AXES: [(&str, &[&str]); 3] = [
    ("x", &["f_act", "f_x", "fx"]),
    ("y", &["y_f_act", "f_y", "fy"]),
    ("z", &["z_f_act", "f_z", "fz"]),
];

/// A sentence about the `headings` that hold position and force of an axis which the position called `read` is not of; none
/// without one.
///
/// A column of either alone may be anything, such as an output `y` of a controller.
pub(super) fn unread(read: &str, headings: &[String]) -> Option<String> {
    let find = |role, names: &[&str]| {
        let is_such = |text: &&String| {
            let name = Heading::of(text, role).name;
            names.iter().any(|it| it.eq_ignore_ascii_case(name))
        };
        headings.iter().find(is_such)
    };
    let name = Heading::of(read, Role::X).name;
    let is_own =
        |axis: &str| name.split('_').next().is_some_and(|it| it.eq_ignore_ascii_case(axis));
    let own = if is_own("y") { 1 } else { 2 * usize::from(is_own("z")) };
    let mut further = Vec::new();
    for (index, (axis, forces)) in AXES.into_iter().enumerate() {
        let columns = find(Role::X, &[axis]).zip(find(Role::F, forces));
        if let Some((position, force)) = columns.filter(|_| index != own) {
            further.extend([shorten(position), shorten(force)]);
        }
    }
    let read = if own == 0 { "the first axis" } else { AXES[own].0 };
    (!further.is_empty()).then(|| {
        format!(
            "the log has columns of further axes ({}): only {read} is read, and energy that passes along the others is missing",
            further.join(", ")
        )
    })
}

#[cfg(test)]
mod tests {
    use super::unread;

    fn told(read: &str, headings: &str) -> Option<String> {
        unread(read, &headings.split(',').map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn an_axis_is_a_position_and_a_force() {
        for (read, headings, columns) in [
            ("x", "t,x,f_act,y,y_v,y_f_env,y_f_act", "(y, y_f_act): only the first axis is read"),
            ("x_measured", "t,x,x_measured,f_act,y,y_f_act,z,z_f_act", "(y, y_f_act, z, z_f_act)"),
            ("y", "t,x,f_act,y,y_f_act", "(x, f_act): only y is read"),
            ("x [mm]", "t,x [mm],y [mm],Fx,Fy [kN]", "(y [mm], Fy [kN]): only the first"),
            ("position", "t,position,f,z_mm,f_z", "(z_mm, f_z): only the first"),
        ] {
            let found = told(read, headings).unwrap_or_default();
            assert!(found.contains(columns), "{headings}: {found}");
        }
    }

    #[test]
    fn a_log_of_one_axis_has_no_further_ones() {
        for headings in ["t,x,f", "t,x,x_measured,v,f_env,f_act", "t,x,f,y", "t,x,f,fy,y_v", "0,1"]
        {
            assert_eq!(told("x", headings), None, "{headings}");
        }
    }
}
