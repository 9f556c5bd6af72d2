//! Version of the binary interface, and the tags of storage.

/// Version of the binary interface: one more whenever a struct, a function or the meaning of a block's storage changes. A
/// function that is only added changes nothing for those who do not call it.
pub const ABI: u32 = 5;

/// Tag of the storage called `block` on the signal called `signal`: it tells initialised storage from other bytes, and
/// one block from another (FNV-1a, with the version of the interface in front).
pub const fn tag(block: &str, signal: &str) -> u32 {
    let mut hash = step(0x811c_9dc5, ABI as u8);
    let mut at = 0;
    while at < block.len() {
        hash = step(hash, block.as_bytes()[at]);
        at += 1;
    }
    hash = step(hash, b'_');
    at = 0;
    while at < signal.len() {
        hash = step(hash, signal.as_bytes()[at]);
        at += 1;
    }
    // Of 31 bits: a tag as wide as a double is then one operand of a comparison on x86-64. So memory that was filled with ones is
    // no tag, and memory that was cleared is none either.
    let hash = hash & 0x7fff_ffff;
    if hash == 0 { 1 } else { hash }
}

const fn step(hash: u32, byte: u8) -> u32 {
    (hash ^ byte as u32).wrapping_mul(0x0100_0193)
}
