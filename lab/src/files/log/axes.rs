//! Axes of a log beside the one that is read.

use super::columns::Role;
use super::heading::Heading;
use crate::text::shorten;

/// The axes of a space, by the names of their positions.
const AXES: [&str; 3] = ["x", "y", "z"];

/// A sentence about the `headings` that hold position and force of an axis which the position called `read` is not of; none
/// without one.
///
/// A column of either alone may be anything, such as an output `y` of a controller.
pub(super) fn unread(read: &str, headings: &[String]) -> Option<String> {
    let name = |text: &str, role| Heading::of(text, role).name.to_lowercase();
    let own = name(read, Role::X);
    let own = own.split('_').next().filter(|it| AXES.contains(it)).unwrap_or(AXES[0]);
    let columns = AXES.into_iter().filter(|axis| *axis != own).filter_map(|axis| {
        let is_force = |name: &str| {
            let of = name
                .strip_suffix("_f_act")
                .or_else(|| Some(name.strip_prefix('f')?.trim_start_matches('_')));
            of == Some(axis) || axis == AXES[0] && name == "f_act"
        };
        let position = headings.iter().find(|it| name(it, Role::X) == axis)?;
        Some([position, headings.iter().find(|it| is_force(&name(it, Role::F)))?])
    });
    let columns: Vec<String> = columns.flatten().map(|text| shorten(text)).collect();
    let read = if own == AXES[0] { "the first axis" } else { own };
    (!columns.is_empty()).then(|| {
        format!(
            "the log has columns of further axes ({}): only {read} is read, and energy that passes along the others is missing",
            columns.join(", ")
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
