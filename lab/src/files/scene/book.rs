//! The keys of one kind of file, for its messages.

/// The noun, keys and smallest example of one kind of file, for its messages.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Book {
    /// One word for the content of such a file.
    pub(crate) noun: &'static str,
    /// Every key and table that ships.
    pub(crate) keys: &'static [Key],
    /// Those of the program's own stabilizers, if such files have any.
    pub(crate) own: fn() -> &'static [Key],
    /// The smallest valid file: the required keys only.
    pub(crate) smallest: &'static str,
}

/// A key with its unit and a correct example line, for messages.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Key {
    /// Its name with its table path.
    pub(crate) path: &'static str,
    /// Its unit; empty if it has none.
    pub(crate) unit: &'static str,
    /// Correct lines, as written within its table; for a table, with its header.
    pub(crate) example: &'static str,
}

/// The key at `path`.
pub(crate) const fn key(path: &'static str, unit: &'static str, example: &'static str) -> Key {
    Key { path, unit, example }
}

/// The number of keys in all these tables.
pub(super) const fn count(tables: &[&[Key]]) -> usize {
    let (mut keys, mut table) = (0, 0);
    while table < tables.len() {
        keys += tables[table].len();
        table += 1;
    }
    keys
}

/// The `N` keys of these tables, one table after the other.
pub(super) const fn joined<const N: usize>(tables: &[&[Key]]) -> [Key; N] {
    let mut keys = [key("", "", ""); N];
    let (mut next, mut table) = (0, 0);
    while table < tables.len() {
        let mut row = 0;
        while row < tables[table].len() {
            keys[next] = tables[table][row];
            (next, row) = (next + 1, row + 1);
        }
        table += 1;
    }
    keys
}

impl Book {
    /// The entry of a key with this table path.
    pub(super) fn find(&self, path: &str) -> Option<&'static Key> {
        // The entry of a list also serves each number in it.
        let path = path.split_once('[').map_or(path, |(list, _)| list);
        self.all().find(|key| key.path == path)
    }

    /// Every key and table.
    pub(super) fn all(&self) -> impl Iterator<Item = &'static Key> {
        self.keys.iter().chain((self.own)())
    }
}

impl Key {
    /// Whether it is a table, or a choice among tables, rather than a value.
    pub(crate) fn is_table(&self) -> bool {
        self.example.starts_with('[')
    }

    /// Its name without the table path.
    pub(super) fn name(&self) -> &'static str {
        split(self.path).1
    }

    /// The table it stands in; empty at the top level.
    pub(super) fn table(&self) -> &'static str {
        split(self.path).0
    }
}

/// A table path and the name in it.
pub(super) fn split(path: &str) -> (&str, &str) {
    path.rsplit_once('.').unwrap_or(("", path))
}
