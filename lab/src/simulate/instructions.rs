//! Vector instructions of the processor that the program runs on.

use pulp::NullaryFnOnce;

/// A set of vector instructions that the processor is known to have.
#[derive(Clone, Copy, Debug)]
pub enum Instructions {
    /// The instructions that every processor of this architecture has.
    Base,
    /// AVX2, 256 bits.
    #[cfg(target_arch = "x86_64")]
    Avx2(pulp::x86::V3),
    /// AVX-512, 512 bits.
    #[cfg(target_arch = "x86_64")]
    Avx512(pulp::x86::V4),
}

impl Instructions {
    /// All sets that this processor has, the best first.
    pub fn all() -> Vec<Self> {
        let mut all = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            all.extend(pulp::x86::V4::try_new().map(Self::Avx512));
            all.extend(pulp::x86::V3::try_new().map(Self::Avx2));
        }
        all.push(Self::Base);
        all
    }

    /// The best set that this processor has.
    pub fn best() -> Self {
        Self::all().first().copied().unwrap_or(Self::Base)
    }

    /// Its name in `map.json`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Base => "base",
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(_) => "avx2",
            #[cfg(target_arch = "x86_64")]
            Self::Avx512(_) => "avx512",
        }
    }

    /// Runs `job` compiled for these instructions. The compiler fuses no multiplication with an addition, so the bits
    /// are the same on all of them.
    #[inline(always)]
    pub(crate) fn run<J: NullaryFnOnce>(self, job: J) -> J::Output {
        match self {
            Self::Base => job.call(),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(token) => token.vectorize(job),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512(token) => token.vectorize(job),
        }
    }
}
