//! The modules of a crate: each with what it defines, imports, mentions and gives methods to.

use super::syntax::{self, Path};
use crate::Tree;
use anyhow::Result;
use quote::ToTokens;
use std::collections::{BTreeMap, BTreeSet};
use syn::{Item, UseTree};

/// Number of a module in [`Modules`].
pub type Id = usize;

/// A module of a crate: a file, or a `mod x { }` in one.
#[derive(Default)]
pub struct Module {
    /// Path of the file from the checkout.
    pub file: String,
    /// The module around it; a root is its own.
    pub parent: Id,
    /// The root of its crate: a library or a program.
    pub root: Id,
    pub children: BTreeMap<String, Id>,
    /// Names of what it defines.
    pub items: BTreeSet<String>,
    /// Imported names, each with the path it stands for.
    pub imports: BTreeMap<String, Path>,
    /// Modules from which everything is imported.
    pub globs: Vec<Path>,
    /// Paths in its code, and those that it imports for itself alone.
    pub mentions: BTreeSet<Path>,
    /// Types that have an `impl` of their own here.
    pub impls: Vec<Path>,
    has_code: bool,
}

impl Module {
    /// Returns `true` if it only declares modules and imports or re-exports.
    pub fn is_facade(&self) -> bool {
        !self.has_code
    }
}

/// The modules of one package.
#[derive(Default)]
pub struct Modules {
    pub all: Vec<Module>,
    /// The root of the library and the name under which the package's programs know it.
    pub library: Option<(String, Id)>,
}

impl Modules {
    /// Reads the package in a folder of `crates`.
    ///
    /// # Errors
    /// When a source cannot be parsed.
    pub fn read(tree: &Tree, folder: &str) -> Result<Self> {
        let mut modules = Self::default();
        let src = format!("crates/{folder}/src");
        if let Some(root) = modules.add_root(tree, &format!("{src}/lib.rs"))? {
            let kerf = ["kerf", "xtask"].iter().all(|name| *name != folder);
            let name = if kerf { format!("kerf-{folder}") } else { folder.to_owned() };
            modules.library = Some((name.replace('-', "_"), root));
        }
        modules.add_root(tree, &format!("{src}/main.rs"))?;
        for (path, _) in tree.matching(&format!("{src}/bin/"), ".rs") {
            let inside = &path[src.len() + "/bin/".len()..];
            if !inside.contains('/') || inside.ends_with("/main.rs") {
                modules.add_root(tree, path)?;
            }
        }
        Ok(modules)
    }

    fn add_root(&mut self, tree: &Tree, path: &str) -> Result<Option<Id>> {
        let Some(text) = tree.text(path) else { return Ok(None) };
        let id = self.all.len();
        let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
        self.all.push(Module { file: path.to_owned(), parent: id, root: id, ..Module::default() });
        self.add_items(tree, id, syntax::file(path, text)?.items, folder)?;
        Ok(Some(id))
    }

    /// Adds items to a module whose children lie in `folder`.
    fn add_items(&mut self, tree: &Tree, id: Id, items: Vec<Item>, folder: &str) -> Result<()> {
        for item in items {
            match item {
                Item::Mod(child) => self.add_child(tree, id, child, folder)?,
                Item::Use(item) => {
                    let is_own = matches!(item.vis, syn::Visibility::Inherited);
                    self.all[id].add_use(&item.tree, &Path::new(), is_own);
                }
                other => self.all[id].add_item(&other),
            }
        }
        Ok(())
    }

    fn add_child(
        &mut self,
        tree: &Tree,
        parent: Id,
        child: syn::ItemMod,
        folder: &str,
    ) -> Result<()> {
        let name = child.ident.to_string().trim_start_matches("r#").to_owned();
        let (below, id, root) = (format!("{folder}/{name}"), self.all.len(), self.all[parent].root);
        let (file, items) = match child.content {
            Some((_, items)) => (self.all[parent].file.clone(), items),
            None => {
                let files = [format!("{below}.rs"), format!("{below}/mod.rs")];
                let Some(file) = files.into_iter().find(|file| tree.text(file).is_some()) else {
                    return Ok(());
                };
                let items = syntax::file(&file, tree.text(&file).unwrap_or_default())?.items;
                (file, items)
            }
        };
        self.all[parent].children.insert(name, id);
        self.all.push(Module { file, parent, root, ..Module::default() });
        self.add_items(tree, id, items, &below)
    }
}

impl Module {
    /// Adds what a `use` imports; a re-export alone makes no file know another one.
    fn add_use(&mut self, tree: &UseTree, prefix: &Path, is_own: bool) {
        let with = |name: &syn::Ident| [prefix.as_slice(), &[plain(name)]].concat();
        match tree {
            UseTree::Path(path) => self.add_use(&path.tree, &with(&path.ident), is_own),
            UseTree::Group(group) => {
                group.items.iter().for_each(|item| self.add_use(item, prefix, is_own));
            }
            UseTree::Glob(_) => self.globs.push(prefix.clone()),
            UseTree::Name(name) if name.ident == "self" => {
                let name = prefix.last().cloned().unwrap_or_default();
                self.add_import(name, prefix.clone(), is_own);
            }
            UseTree::Name(name) => self.add_import(plain(&name.ident), with(&name.ident), is_own),
            UseTree::Rename(name) => {
                let path = if name.ident == "self" { prefix.clone() } else { with(&name.ident) };
                self.add_import(plain(&name.rename), path, is_own);
            }
        }
    }

    fn add_import(&mut self, name: String, path: Path, is_own: bool) {
        if is_own {
            self.mentions.insert(path.clone());
        }
        self.imports.insert(name, path);
    }

    fn add_item(&mut self, item: &Item) {
        self.has_code = true;
        self.items.extend(name(item).map(plain));
        if let Item::Impl(item) = item
            && item.trait_.is_none()
            && let syn::Type::Path(of) = item.self_ty.as_ref()
        {
            self.impls.push(of.path.segments.iter().map(|segment| plain(&segment.ident)).collect());
        }
        self.mentions.extend(syntax::paths(item.to_token_stream()));
    }
}

fn plain(name: &syn::Ident) -> String {
    name.to_string().trim_start_matches("r#").to_owned()
}

fn name(item: &Item) -> Option<&syn::Ident> {
    Some(match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        Item::Union(item) => &item.ident,
        _ => return None,
    })
}
