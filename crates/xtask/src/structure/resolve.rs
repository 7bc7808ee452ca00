//! Paths to the files that define what they name.

use super::Graph;
use super::modules::{Id, Modules};
use std::collections::{BTreeMap, BTreeSet};

/// Something a path leads to.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Target {
    Module(Id),
    /// An item of a module, by its name.
    Item(Id, String),
}

/// Imported names that are being looked up, each with its module: an import that leads back to itself ends there.
type Pending = BTreeSet<(Id, String)>;

impl Modules {
    /// The files by path, each with the others that it knows.
    pub fn graph(&self) -> Graph {
        let mut graph = Graph::new();
        for (id, module) in self.all.iter().enumerate().filter(|(_, module)| !module.is_facade()) {
            let known = graph.entry(module.file.clone()).or_default();
            for target in module.mentions.iter().flat_map(|path| self.targets(id, path)) {
                if let Target::Item(of, name) = target {
                    known.entry(self.all[of].file.clone()).or_default().insert(name);
                }
            }
        }
        for (file, known) in &mut graph {
            known.remove(file);
        }
        graph
    }

    /// The files with an `impl` of each type, by the type's file and name.
    pub fn impls(&self) -> BTreeMap<(String, String), BTreeSet<String>> {
        let mut impls: BTreeMap<_, BTreeSet<String>> = BTreeMap::new();
        for (id, module) in self.all.iter().enumerate() {
            for target in module.impls.iter().flat_map(|path| self.targets(id, path)) {
                if let Target::Item(of, name) = target {
                    let key = (self.all[of].file.clone(), name);
                    impls.entry(key).or_default().insert(module.file.clone());
                }
            }
        }
        impls
    }

    fn targets(&self, from: Id, path: &[String]) -> BTreeSet<Target> {
        self.path(from, path, &mut Pending::new())
    }

    /// Follows a path from the module that writes it.
    fn path(&self, from: Id, path: &[String], pending: &mut Pending) -> BTreeSet<Target> {
        let Some((first, rest)) = path.split_first() else { return [Target::Module(from)].into() };
        match (first.as_str(), &self.library) {
            ("crate", _) => self.below(self.all[from].root, rest, pending),
            ("self" | "super", _) => self.below(from, path, pending),
            (name, Some((library, root))) if name == library => self.below(*root, rest, pending),
            _ => self.name(from, path, pending),
        }
    }

    /// Follows the rest of a path that has reached a module.
    fn below(&self, module: Id, path: &[String], pending: &mut Pending) -> BTreeSet<Target> {
        match path.split_first() {
            None => [Target::Module(module)].into(),
            Some((first, rest)) if first == "self" => self.below(module, rest, pending),
            Some((first, rest)) if first == "super" => {
                self.below(self.all[module].parent, rest, pending)
            }
            Some(_) => self.name(module, path, pending),
        }
    }

    /// Looks the first name of a path up in a module: what it defines, imports, or imports with all others.
    fn name(&self, id: Id, path: &[String], pending: &mut Pending) -> BTreeSet<Target> {
        let Some((name, rest)) = path.split_first() else { return BTreeSet::new() };
        let (module, mut found) = (&self.all[id], BTreeSet::new());
        if let Some(child) = module.children.get(name) {
            found.extend(self.below(*child, rest, pending));
            // A function may bear the name of a module, but nothing lies in it. What is not seen in the module (a macro
            // may make it) is there all the same.
            if let Some(last) = rest.first() {
                if found.is_empty() {
                    found.insert(Target::Item(*child, last.clone()));
                }
                return found;
            }
        }
        if module.items.contains(name) {
            found.insert(Target::Item(id, name.clone()));
        }
        if pending.insert((id, name.clone())) {
            if let Some(import) = module.imports.get(name) {
                found.extend(self.path(id, &[import, rest].concat(), pending));
            }
            if found.is_empty() {
                let globs = module.globs.iter();
                found.extend(globs.flat_map(|glob| self.through_glob(id, glob, path, pending)));
            }
            pending.remove(&(id, name.clone()));
        }
        found
    }

    fn through_glob(
        &self,
        id: Id,
        glob: &[String],
        path: &[String],
        pending: &mut Pending,
    ) -> BTreeSet<Target> {
        let mut found = BTreeSet::new();
        for target in self.path(id, glob, pending) {
            if let Target::Module(module) = target {
                found.extend(self.name(module, path, pending));
            }
        }
        found
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::Tree;

    fn modules(files: &[(&str, &str)]) -> Modules {
        let files: Vec<_> =
            files.iter().map(|(f, text)| (format!("crates/a/src/{f}"), *text)).collect();
        let files: Vec<_> = files.iter().map(|(f, text)| (f.as_str(), *text)).collect();
        Modules::read(&Tree::of(&files), "a").unwrap()
    }

    /// Holds the files that `user.rs` knows against those expected, in a crate with this text in the file.
    fn check(user: &str, expected: &[&str]) {
        let modules = modules(&[
            (
                "lib.rs",
                "mod room;\nmod user;\npub use room::{Table, chair as seat, own as user};\n",
            ),
            (
                "room/mod.rs",
                "mod chair;\nmod table;\npub use table::*;\npub use chair::chair;\nfn own() {}\n",
            ),
            ("room/chair.rs", "pub fn chair() {}\n"),
            (
                "room/table.rs",
                "pub enum Table { Round }\n#[cfg(test)]\nmod tests { use crate::user::f; }\n",
            ),
            ("user.rs", user),
        ]);
        let graph = modules.graph();
        let known = graph.get("crates/a/src/user.rs").cloned().unwrap_or_default();
        let known: Vec<&str> =
            known.keys().map(|file| file.trim_start_matches("crates/a/src/")).collect();
        assert_eq!(known, expected, "{user}");
        assert!(!graph.contains_key("crates/a/src/lib.rs"), "{graph:?}");
        assert!(graph["crates/a/src/room/table.rs"].is_empty(), "{graph:?}");
        assert!(graph["crates/a/src/room/mod.rs"].is_empty(), "{graph:?}");
    }

    #[test]
    fn names_lead_to_the_file_that_defines() {
        check("fn f() { std::fs::read(x) }", &[]);
        check("use crate::Table;\nfn f() {}", &["room/table.rs"]);
        check("fn f() { super::seat() }", &["room/chair.rs"]);
        check("use crate::room;\nfn f() { vec![room::chair()] }", &["room/chair.rs"]);
        check("use crate::*;\nfn f() -> Table { Table::Round }", &["room/table.rs"]);
        check("fn f() { a::room::own() }", &[]);
        check("fn g() { crate::user::f() }", &[]);
        check("fn f() { kerf_a::room::own() }", &["room/mod.rs"]);
        check("mod inner { use super::super::room::{self, Table}; fn g() {} }", &["room/table.rs"]);
        check("use crate::room::chair::Seat;\nfn f() {}", &["room/chair.rs"]);
        check("pub use crate::Table;\nfn f() {}", &[]);
        check("pub use crate::Table;\nfn f() -> Table {}", &["room/table.rs"]);
        check("use crate::Table;", &[]);
        check("#[cfg(test)]\nuse crate::Table;\nfn f() {}", &[]);
        check("use chair::chair as chair;\nfn f() { chair::chair() }", &[]);
    }

    #[test]
    fn impls_are_counted_for_the_type_that_they_are_of() {
        let modules = modules(&[
            ("lib.rs", "mod x;\nmod y;\nmod z;\npub struct T;\nimpl T {}\n"),
            ("x.rs", "use super::T;\nimpl<A> T<A> {}\nstruct U;\nimpl U {}\n"),
            ("z.rs", "impl Clone for super::T {}\n"),
            ("y.rs", "struct T;\nimpl T {}\nimpl crate::T {}\n"),
        ]);
        let impls = modules.impls();
        let files = |file: &str, name: &str| {
            impls[&(format!("crates/a/src/{file}"), name.to_owned())].len()
        };
        assert_eq!([files("lib.rs", "T"), files("x.rs", "U"), files("y.rs", "T")], [3, 1, 1]);
    }
}
