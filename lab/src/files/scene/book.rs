//! What is known of the keys of one kind of file.

/// What messages about one kind of file are made of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Book {
    /// What such a file holds, in one word.
    pub(crate) noun: &'static str,
    /// Every key and table.
    pub(crate) keys: &'static [Key],
    /// A file that holds what is required and nothing else.
    pub(crate) smallest: &'static str,
}

/// What messages say about a key: its unit, and a line that would be right.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Key {
    /// Its name with its table path.
    pub(crate) path: &'static str,
    /// Its unit; empty where it has none.
    pub(crate) unit: &'static str,
    /// Lines that are right, from within its table; for a table, with its header.
    pub(crate) example: &'static str,
}

/// The key at `path`.
pub(crate) const fn key(path: &'static str, unit: &'static str, example: &'static str) -> Key {
    Key { path, unit, example }
}

/// How many keys these tables have together.
pub(super) const fn count(tables: &[&[Key]]) -> usize {
    let (mut keys, mut table) = (0, 0);
    while table < tables.len() {
        keys += tables[table].len();
        table += 1;
    }
    keys
}

/// The keys of these tables, one table after the other, `N` together.
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
        // What is said of a list is said of each number in it.
        let path = path.split_once('[').map_or(path, |(list, _)| list);
        self.keys.iter().find(|key| key.path == path)
    }
}

impl Key {
    /// Whether it is a table, or one that chooses among tables, rather than a value.
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
