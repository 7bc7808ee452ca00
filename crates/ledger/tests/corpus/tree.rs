//! The folders that the files of the corpus once lay in.
//!
//! The corpus keeps its files side by side under names that say where they came from; its list
//! tells each one's path. Here they get their paths back, so that FP and C# find what they name:
//! the maker's own below the folder that Windows calls `C:\SbParts`, the others below a folder of
//! their own.

use kerf_files::Folders;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// The maker's files; their paths begin with the part folder.
const MAKER: &str = "fablab-5ax";

/// Files that others name and the corpus does not have: our own, as short as they can be.
const STAND_INS: &str = include_str!("stand_ins.txt");

/// File with the path at which it lies.
struct Placed {
    name: String,
    source: String,
    path: PathBuf,
    /// Several versions of one file have the same path; the last stands there.
    bytes: Vec<u8>,
}

/// The folders on disk.
pub struct Tree {
    root: TempDir,
    files: Vec<Placed>,
}

impl Tree {
    /// Builds the folders from a corpus.
    pub fn build(corpus: &Path) -> Self {
        let root = tempfile::tempdir().unwrap();
        let list = fs::read_to_string(corpus.join("manifest.tsv")).unwrap();
        let mut files = Vec::new();
        for line in list.lines() {
            let columns: Vec<&str> = line.split('\t').collect();
            if columns[1] != "sbp" {
                continue;
            }
            let bytes = fs::read(corpus.join("sbp").join(columns[2])).unwrap();
            let placed = Placed::new(columns[2], columns[4], bytes);
            put(&root.path().join(&placed.path), &placed.bytes);
            files.push(placed);
        }
        files.sort_by(|a, b| a.name.cmp(&b.name));
        let tree = Self { root, files };
        tree.put_stand_ins();
        tree
    }

    fn put_stand_ins(&self) {
        let lines = STAND_INS.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
        for line in lines {
            let parts: Vec<&str> = line.split('|').map(str::trim).collect();
            let [path, text, reason] = parts[..] else { panic!("three columns: {line}") };
            assert!(!reason.is_empty(), "{line}: no reason");
            let path = self.root.path().join(path);
            assert!(!path.exists(), "{line}: the corpus has it");
            put(&path, text.replace('⏎', "\n").as_bytes());
        }
    }

    /// Names of the files in the corpus, in order.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        self.files.iter().map(|file| file.name.as_str())
    }

    /// Content of a file of the corpus.
    pub fn bytes(&self, file: &str) -> &[u8] {
        &self.placed(file).bytes
    }

    /// Path at which a file of the corpus lies now.
    pub fn path(&self, file: &str) -> PathBuf {
        self.root.path().join(&self.placed(file).path)
    }

    /// The folder that all lie in.
    pub fn root(&self) -> &Path {
        self.root.path()
    }

    /// The folders that a file of the corpus reaches: the part folder and its custom cuts.
    pub fn folders(&self, file: &str) -> Folders {
        let placed = self.placed(file);
        let root = self.root.path().join(&placed.source);
        if placed.source == MAKER {
            return Folders::new(root.clone(), vec![root.join("Custom")], Vec::new());
        }
        let own = self.path(file).parent().unwrap().to_owned();
        Folders::new(own.clone(), vec![own], vec![root])
    }

    fn placed(&self, file: &str) -> &Placed {
        self.files.iter().find(|placed| placed.name == file).expect("a file of the corpus")
    }
}

impl Placed {
    fn new(name: &str, path: &str, bytes: Vec<u8>) -> Self {
        let (source, _) = name.split_once("__").expect("source__name");
        let inside = match (source, path) {
            // It lies above the part folder there, where no program looks for it.
            (MAKER, "my_variables.sbc") => "Custom/my_variables.sbc",
            _ => path.strip_prefix("sbparts/").unwrap_or(path),
        };
        let path = Path::new(source).join(inside);
        Self { name: name.to_owned(), source: source.to_owned(), path, bytes }
    }
}

fn put(path: &Path, bytes: &[u8]) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, bytes).unwrap();
}
