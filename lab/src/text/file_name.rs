//! Name of a file within a title.

use std::path::Path;

/// The last part of a path, which a title has room for; the whole text if it has none.
pub(crate) fn file_name(path: &str) -> &str {
    Path::new(path).file_name().and_then(|name| name.to_str()).unwrap_or(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_ends_in_its_name() {
        for (path, name) in [
            ("scenes/a.toml", "a.toml"),
            ("a.toml", "a.toml"),
            ("/long/way to/b.toml", "b.toml"),
            ("..", ".."),
            ("", ""),
        ] {
            assert_eq!(file_name(path), name);
        }
    }
}
