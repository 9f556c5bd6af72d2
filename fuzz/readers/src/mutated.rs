//! Tests of the readers over shipped files that were changed at random places.

use std::path::Path;
use std::{fs, panic};

use super::KINDS;

/// Changed texts of each file.
const CHANGES: u64 = 40;

/// What is put into a text now and then.
const WORDS: [&str; 24] = [
    "=",
    "[",
    "]",
    "{ ",
    " }",
    "\"",
    "\n",
    ",",
    ".",
    "-",
    "nan",
    "inf",
    "1e308",
    "-1e308",
    "1e-320",
    "0",
    "18446744073709551616",
    "true",
    "\u{1b}[2J",
    "\0",
    "\u{feff}",
    "#",
    "..",
    ":",
];

/// Numbers of SplitMix64.
struct Random(u64);

impl Random {
    fn below(&mut self, most: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let bits = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((bits ^ (bits >> 31)) % most.max(1) as u64) as usize
    }

    /// One to four changes of `bytes`.
    fn changed(&mut self, bytes: &[u8]) -> Vec<u8> {
        let mut changed = bytes.to_vec();
        for _ in 0..=self.below(4) {
            let at = self.below(changed.len());
            let end = (at + self.below(20)).min(changed.len());
            match self.below(5) {
                0 => changed.truncate(at),
                1 => drop(changed.drain(at..end)),
                2 => changed.extend_from_within(at..end),
                3 if at < changed.len() => changed[at] = self.below(256) as u8,
                _ => {
                    let word = WORDS[self.below(WORDS.len())];
                    changed.splice(at..end.min(at + 3), word.bytes());
                }
            }
        }
        changed
    }
}

/// The texts that a reader begins from.
fn begins(kind: &str) -> Vec<Vec<u8>> {
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR"))
        .ancestors()
        .map(|it| it.join("scenes"))
        .find(|it| it.join("tour.toml").is_file())
        .expect("the folder of scenes");
    let files = |folder: &str, ending: &str| -> Vec<Vec<u8>> {
        let mut paths: Vec<_> = fs::read_dir(shipped.join(folder))
            .expect("a folder")
            .map(|it| it.expect("an entry").path())
            .filter(|it| it.extension().is_some_and(|it| it == ending))
            .collect();
        paths.sort();
        paths.iter().map(|it| fs::read(it).expect("a file")).collect()
    };
    let lines = |text: &[u8]| {
        text.split_inclusive(|it| *it == b'\n').take(200).collect::<Vec<_>>().concat()
    };
    match kind {
        "scene" => files("", "toml"),
        "model" => files("models", "toml"),
        "teleoperator" => files("teleoperation", "toml"),
        "log" | "identified log" => files("logs", "csv").iter().map(|it| lines(it)).collect(),
        "table" | "unfinished table" => vec![super::written_table()],
        "motion" => vec![fs::read(shipped.join("motion-file.csv")).expect("a file")],
        _ => [
            "run\nscene.toml\n--csv\nrows.csv",
            "map\nscene.toml\n--x\ndevice.mass=0.1..1:4\n--y\ndevice.damping=0.1..1:4:log\n--stabilizers\npopc,lolc",
            "compare\na.toml\nb.toml\n--stabilizers\nall\n--json",
            "observe\n-\n--columns\nt,x,f\n--scale\nx=1e-3,f=-1\n--contact\n0.5",
            "tune\nscene.toml\n--trials\n6\n--runs\n2\n--stabilizers\npopc",
            "hard\n--stabilizer\npopc",
            "identify\nlog.csv\n--columns\n1,2,3",
            "--help",
        ]
        .iter()
        .map(|it| it.as_bytes().to_vec())
        .collect(),
    }
}

#[test]
fn changed_files_are_read_or_refused() {
    for (index, (kind, reader)) in KINDS.iter().enumerate() {
        for (number, begin) in begins(kind).iter().enumerate() {
            reader(begin);
            for change in 0..CHANGES {
                let seed = (index as u64) << 32 | (number as u64) << 16 | change;
                let bytes = Random(seed).changed(begin);
                let read = panic::catch_unwind(|| reader(&bytes));
                assert!(read.is_ok(), "{kind} {number}, change {change}");
            }
        }
    }
}
