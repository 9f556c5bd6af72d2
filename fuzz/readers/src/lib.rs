//! Fuzz target of what reads files and command lines.

mod readers;

/// The reader that the first byte chooses, over the rest.
pub fn readers(bytes: &[u8]) {
    if let [kind, rest @ ..] = bytes {
        readers::KINDS[usize::from(*kind) % readers::KINDS.len()].1(rest);
    }
}
