//! Scenes from files.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process;

use super::{FULL, SMALLEST, scene};
use crate::files::scene::{Diagnostic, Scene};

/// A folder for one test, removed when the test ends.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("lyapunov-scene-{}-{name}", process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn file(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        fs::write(&path, content).unwrap();
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn refused(path: &Path, words: &[&str]) -> Diagnostic {
    let fault = Scene::load(path).unwrap_err();
    let shown = fault.to_string();
    assert_eq!(fault.name(), path.display().to_string());
    assert!(!fault.help().is_empty(), "no remedy in:\n{shown}");
    let unfolded = shown.split_whitespace().collect::<Vec<_>>().join(" ");
    for word in words {
        assert!(unfolded.contains(word), "no {word:?} in:\n{shown}");
    }
    fault
}

#[test]
fn a_file_is_read_like_its_text() {
    let folder = Folder::new("good");
    assert_eq!(Scene::load(&folder.file("full.toml", FULL)), Ok(scene(FULL)));
    let windows = format!("\u{feff}{}", SMALLEST.replace('\n', "\r\n"));
    assert_eq!(Scene::load(&folder.file("windows.toml", windows)), Ok(scene(SMALLEST)));
    let bad = folder.file("bad.toml", FULL.replace("mass = 0.2", "mass = -0.2"));
    let fault = refused(&bad, &["device.mass"]);
    assert!(fault.to_string().starts_with(&format!("error: {}:15:8: ", bad.display())));
}

#[test]
fn files_that_are_no_scenes_are_rejected() {
    let folder = Folder::new("bad");
    refused(&folder.0.join("absent.toml"), &["no such file", "check the path"]);
    refused(&folder.0, &["this is a folder", "path of a scene file"]);
    refused(&folder.file("empty.toml", ""), &["the scene is empty", "[environment.wall]"]);
    refused(&folder.file("latin.toml", b"# b\xe9ta\n"), &["UTF-8", "0xe9 at offset 3"]);
    refused(&folder.file("zero.toml", b"duration\0= 1"), &["UTF-8", "0x00 at offset 8"]);
    refused(&folder.file("wide.toml", b"\xff\xfed\0u\0"), &["offset 0", "UTF-16"]);
    let inside = folder.file("file", "").join("scene.toml");
    refused(&inside, &["path of a scene file"]);
}

#[test]
fn the_size_is_limited() {
    let folder = Folder::new("size");
    let mut content = format!("{SMALLEST}\n").into_bytes();
    content.resize(1 << 20, b'#');
    assert_eq!(Scene::load(&folder.file("most.toml", &content)), Ok(scene(SMALLEST)));
    content.push(b'#');
    refused(
        &folder.file("more.toml", &content),
        &["too large", "1048577 bytes", "at most 1048576 bytes"],
    );
    let huge = folder.0.join("huge.toml");
    File::create(&huge).and_then(|file| file.set_len(1 << 40)).unwrap();
    refused(&huge, &["too large", "1099511627776 bytes"]);
}

#[cfg(unix)]
#[test]
fn reading_an_endless_device_stops() {
    refused(Path::new("/dev/zero"), &["too large", "more than 1 MiB"]);
    refused(Path::new("/dev/null"), &["the scene is empty"]);
}
