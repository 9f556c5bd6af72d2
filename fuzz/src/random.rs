//! Random bytes, the same for the same seed.

/// `count` bytes of a seed: the numbers of SplitMix64 (Steele, Lea and Flood 2014).
pub fn random(seed: u64, count: usize) -> Vec<u8> {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mut next = || {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    };
    let words = (0..count.div_ceil(8)).flat_map(|_| next().to_le_bytes());
    words.take(count).collect()
}
