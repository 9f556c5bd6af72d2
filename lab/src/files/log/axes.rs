//! Axes of a log beside the one that is read.

use super::columns::Role;
use super::heading::Heading;
use crate::text::shorten;

/// The axes of a space.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Parts of the names of positions and of forces beside that of their axis.
const POSITIONS: [&str; 4] = ["", "pos", "position", "x"];
const FORCES: [&str; 3] = ["f", "force", "f_act"];

/// The parts of a name without that of `axis`; none where it has no such part.
fn beside(name: &str, axis: &str) -> Option<String> {
    let mut parts: Vec<&str> = name.split('_').collect();
    let at = parts.iter().position(|it| it.eq_ignore_ascii_case(axis))?;
    parts.remove(at);
    Some(parts.join("_").to_ascii_lowercase())
}

fn is_position(name: &str, axis: &str) -> bool {
    beside(name, axis).is_some_and(|it| POSITIONS.contains(&it.as_str()))
}

fn is_force(name: &str, axis: &str) -> bool {
    // The first axis of a scene's rows has no name.
    let own = if axis == "x" { "f_act" } else { "" };
    beside(name, axis).is_some_and(|it| FORCES.contains(&it.as_str()))
        || [own, &format!("f{axis}")].iter().any(|it| it.eq_ignore_ascii_case(name))
}

/// A sentence about the `headings` that hold position and force of an axis which the position called `read` is not of; none
/// without one.
///
/// A column of either alone may be anything, such as an output `y` of a controller.
pub(super) fn unread(read: &str, headings: &[String]) -> Option<String> {
    let find = |role, is_such: &dyn Fn(&str) -> bool| {
        headings.iter().find(|text| is_such(Heading::of(text, role).name))
    };
    let name = Heading::of(read, Role::X).name;
    let own = (1..AXES.len()).find(|it| beside(name, AXES[*it]).is_some()).unwrap_or(0);
    let mut further = Vec::new();
    for axis in AXES.iter().filter(|it| **it != AXES[own]) {
        let position = find(Role::X, &|name| is_position(name, axis));
        if let Some((position, force)) = position.zip(find(Role::F, &|name| is_force(name, axis))) {
            further.extend([shorten(position), shorten(force)]);
        }
    }
    let read = if own == 0 { "the first axis" } else { AXES[own] };
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
            ("pos", "time,pos,force,pos_y,force_y", "(pos_y, force_y): only the first"),
            ("x", "t,x,f,x_y,y_f", "(x_y, y_f): only the first"),
            ("pos_y", "t,pos_x,force_x,pos_y,force_y", "(pos_x, force_x): only y"),
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
