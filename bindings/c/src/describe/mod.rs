//! Description of the functions and structs of C, of which the headers are written.
//!
//! Names, types, sizes and offsets are those of the compiled functions: a declaration cannot differ from its definition.

mod c_type;
mod cpp;
mod fixed;

pub use c_type::CType;
pub use cpp::Function;

use std::fmt::Write;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::kept::{Keep, Kind, Storage, WordOf};

/// Header that is being written.
#[derive(Debug, Default)]
pub struct Header {
    /// The text of the header between its frame.
    pub text: String,
    /// All functions.
    pub described: Vec<Function>,
    /// The names of all blocks, and what they are.
    pub blocks: Vec<(String, String)>,
}

/// Field of a struct.
#[derive(Debug)]
pub struct Field<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its type.
    pub c_type: String,
    /// Where it begins.
    pub offset: usize,
    /// What it is.
    pub about: &'a [&'a str],
}

/// Struct that no block brings.
pub trait Form: CType {
    /// Its fields.
    fn fields() -> Vec<Field<'static>>;
}

impl Header {
    /// The whole library.
    pub fn whole() -> Self {
        let mut header = Self::default();
        fixed::describe(&mut header);
        crate::limits::of_f32::describe(&mut header);
        crate::limits::of_f64::describe(&mut header);
        crate::blocks::describe(&mut header);
        header
    }

    fn comment(&mut self, indent: &str, lines: &[&str]) {
        let text: Vec<_> = lines.iter().map(|line| line.trim()).collect();
        let mut column = indent.len() + 2;
        let _ = write!(self.text, "{indent}/*");
        for word in text.join(" ").split_whitespace() {
            if column + word.len() > 110 {
                let _ = write!(self.text, "\n{indent}  ");
                column = indent.len() + 2;
            }
            let _ = write!(self.text, " {word}");
            column += 1 + word.len();
        }
        let _ = writeln!(self.text, " */");
    }

    /// A heading.
    pub fn block(&mut self, name: &str, about: &[&str]) {
        let _ = writeln!(self.text);
        self.comment("", &[&[name, ":"].concat(), &about.join(" ")]);
        let about: Vec<_> = about.iter().map(|line| line.trim()).collect();
        if name.starts_with("lyapunov_") {
            self.blocks.push((name.into(), about.join(" ")));
        }
    }

    /// A function.
    pub fn function(
        &mut self,
        name: &str,
        about: &[&str],
        returned: String,
        arguments: &[(&str, String)],
    ) {
        self.comment("", about);
        let list: Vec<_> =
            arguments.iter().map(|(name, c)| format!("{c}{}{name}", gap(c))).collect();
        let list = if list.is_empty() { "void".to_string() } else { list.join(", ") };
        let looked_at = if returned == "lyapunov_status" { "LYAPUNOV_MUST_LOOK_AT " } else { "" };
        let declared = format!("{looked_at}{returned}{}{name}({list})", gap(&returned));
        let _ = writeln!(self.text, "LYAPUNOV_API {declared};");
        let about: Vec<_> = about.iter().map(|line| line.trim()).collect();
        self.described.push(Function {
            name: name.into(),
            about: about.join(" "),
            returned,
            arguments: arguments.iter().map(|(name, c)| ((*name).into(), c.clone())).collect(),
        });
        if name.ends_with("_init_abi") {
            let short = name.trim_end_matches("_abi");
            let _ = writeln!(
                self.text,
                "#define {short}(storage, parameters) {name}((storage), (parameters), LYAPUNOV_ABI)"
            );
        }
    }

    /// A struct with its fields.
    pub fn fields(&mut self, name: &str, size: usize, fields: &[Field<'_>]) {
        let _ = writeln!(self.text, "typedef struct {name} {{");
        for field in fields {
            self.comment("    ", field.about);
            let (c, name) = (&field.c_type, field.name);
            let (c, array) = c
                .split_once('[')
                .map_or((c.as_str(), String::new()), |(c, count)| (c, format!("[{count}")));
            let _ = writeln!(self.text, "    {c}{}{name}{array};", gap(c));
        }
        let _ = writeln!(self.text, "}} {name};");
        let _ = writeln!(self.text, "LYAPUNOV_ASSERT(sizeof({name}) == {size}, {name}_size);");
        for Field { name: field, offset, .. } in fields {
            let _ = writeln!(
                self.text,
                "LYAPUNOV_ASSERT(offsetof({name}, {field}) == {offset}, {name}_{field});"
            );
        }
    }

    /// A struct that no block brings.
    pub fn form<F: Form>(&mut self) {
        let mut fields = F::fields();
        // C has no empty arrays.
        fields.retain(|field| !field.c_type.ends_with("[0]"));
        self.fields(&F::name(), size_of::<F>(), &fields);
    }

    /// The parameters of a block.
    pub fn parameters<K: Kind>(&mut self, name: &str, fields: &[Field<'_>]) {
        let name = format!("{name}_parameters");
        self.fields(&name, size_of::<K::Parameters>(), fields);
    }

    /// The storage of a block, and its memory.
    pub fn storage<K: Kind<Memory: CType>>(&mut self, name: &str)
    where
        K::Kept: Keep<K>,
        WordOf<K>: CType,
    {
        let word = size_of::<WordOf<K>>();
        let count = (size_of::<Storage<K>>() - word) / word;
        let set = format!("Set by init: {:#010x}.", K::TAG);
        let tag = Field {
            name: "tag",
            c_type: WordOf::<K>::name(),
            offset: 0,
            about: &[&set, "Storage is copied as any struct and compared by memcmp."],
        };
        let kept = Field {
            name: "kept",
            c_type: format!("{}[{count}]", WordOf::<K>::name()),
            offset: word,
            about: &["The library's own."],
        };
        self.fields(name, size_of::<Storage<K>>(), &[tag, kept]);
        let count = size_of::<K::Memory>() / word;
        let words = Field {
            name: "word",
            c_type: format!("{}[{count}]", WordOf::<K>::name()),
            offset: 0,
            about: &["The memory without the parameters, to be stored."],
        };
        self.fields(&K::Memory::name(), size_of::<K::Memory>(), &[words]);
    }
}

/// The blank between a type and a name.
fn gap(c_type: &str) -> &'static str {
    if c_type.ends_with('*') { "" } else { " " }
}
