//! The header for C++: a class for each block on each signal, of the same functions as the header for C.

use std::fmt::Write;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::Header;

/// Function of C.
#[derive(Debug)]
pub struct Function {
    pub(super) name: String,
    pub(super) about: String,
    pub(super) returned: String,
    pub(super) arguments: Vec<(String, String)>,
}

impl Function {
    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its use of the block of this name, if it is one of its functions.
    fn verb(&self, block: &str) -> Option<&str> {
        self.name.strip_prefix(block)?.strip_prefix('_')
    }
}

/// Verbs that frame.hpp has for every block.
const LIFE: [&str; 4] = ["init_abi", "retune", "save", "restore"];
/// Verbs that it has for every block with an account.
const ACCOUNT: [&str; 4] = ["observed_energy", "reset", "grant", "owe"];

impl Header {
    /// The classes.
    pub fn classes(&self) -> String {
        let mut text = String::new();
        let mut declared = Vec::new();
        for (name, about) in &self.blocks {
            let Some((block, signal)) = split(name) else { continue };
            let class = camel(block);
            if !declared.contains(&class) {
                let _ = writeln!(text, "\n/* {about} */\ntemplate <class Signal> class {class};");
                declared.push(class.clone());
            }
            let verbs: Vec<_> =
                self.described.iter().filter_map(|it| Some((it.verb(name)?, it))).collect();
            let has = |verb: &&str| verbs.iter().any(|(it, _)| it == verb);
            let account = ACCOUNT.iter().all(has);
            let (calls, base) =
                if account { ("ACCOUNT", "LyapunovAccount") } else { ("BLOCK", "LyapunovBlock") };
            let signal_name = cpp_signal(signal);
            let _ = writeln!(text, "\nLYAPUNOV_{calls}({name})");
            let _ = writeln!(
                text,
                "template <> class {class}<{signal_name}> : public detail::{base}<{name}> {{\npublic:"
            );
            for (verb, function) in verbs {
                if !(LIFE.contains(&verb) || account && ACCOUNT.contains(&verb)) {
                    method(&mut text, signal, verb, function);
                }
            }
            let _ = writeln!(text, "}};");
        }
        text
    }
}

/// The block and the signal of a name.
fn split(name: &str) -> Option<(&str, &str)> {
    name.strip_prefix("lyapunov_")?.rsplit_once('_')
}

fn camel(block: &str) -> String {
    let upper = |word: &str| word[..1].to_uppercase() + &word[1..];
    block.split('_').map(upper).collect::<Vec<_>>().concat()
}

fn number(signal: &str) -> &'static str {
    if signal.starts_with("f32") { "float" } else { "double" }
}

/// The signal as the parameter of a class.
fn cpp_signal(signal: &str) -> String {
    match &signal[3..] {
        "" => number(signal).to_string(),
        "screw" => format!("Screw<{}>", number(signal)),
        axes => format!("Axes<{}, {}>", number(signal), &axes[1..]),
    }
}

/// How many numbers a signal has.
fn numbers(signal: &str) -> &str {
    match &signal[3..] {
        "screw" => "6",
        axes => &axes[1..],
    }
}

fn method(text: &mut String, signal: &str, verb: &str, function: &Function) {
    let form = format!("const lyapunov_{signal} *");
    let (mut taken, mut handed) = (Vec::new(), std::vec!["&storage".to_string()]);
    let (mut before, mut given_back) = (String::new(), None);
    let (mut template, mut is_const) = ("", false);
    for (name, c) in &function.arguments {
        match c.as_str() {
            _ if name == "storage" => is_const = c.starts_with("const"),
            _ if name == "context" => handed.push("detail::address(candidate)".into()),
            c if c.starts_with("lyapunov_candidate") => {
                template = "    template <class Function>\n";
                taken.push("Function &&function".to_string());
                let sample = format!("lyapunov_sample_{signal}");
                before.push_str("detail::Candidate<Function> candidate = function; ");
                handed.push(format!(
                    "&detail::call<std::remove_reference_t<decltype(candidate)>, {}, {sample}>",
                    number(signal)
                ));
            }
            c if c == form => {
                taken.push(format!("View<{}, {}> {name}", number(signal), numbers(signal)));
                handed.push(format!("&{name}_form"));
                let _ = write!(
                    before,
                    "const auto {name}_form = detail::form<{}>({name}); ",
                    &c[6..c.len() - 2]
                );
            }
            c if c.starts_with("const ") => {
                taken.push(format!("{}&{name}", &c[..c.len() - 1]));
                handed.push(format!("&{name}"));
            }
            c if c.ends_with('*') => {
                let value = c.trim_end_matches([' ', '*']).to_string();
                let _ = write!(before, "auto {name} = detail::unanswered<{value}>(); ");
                handed.push(format!("&{name}"));
                given_back = Some((value, name.clone()));
            }
            c => {
                taken.push(format!("{c} {name}"));
                handed.push(name.clone());
            }
        }
    }
    let call = format!("{}({})", function.name, handed.join(", "));
    let taken = taken.join(", ");
    let constant = if is_const { " const" } else { "" };
    let _ = writeln!(text, "    /* {} */", function.about);
    let (returned, body) = match (function.returned.as_str(), given_back) {
        (_, Some((value, name))) => (value, format!("{before}{call}; return {name};")),
        ("lyapunov_status", None) => ("Status".into(), format!("{before}return Status({call});")),
        ("uint32_t", None) => ("Code".into(), format!("{before}return static_cast<Code>({call});")),
        (number, None) => (number.into(), format!("{before}return {call};")),
    };
    let _ =
        writeln!(text, "{template}    {returned} {verb}({taken}){constant} noexcept {{ {body} }}");
}
