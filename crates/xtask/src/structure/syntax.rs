//! Source text to items and paths: code for tests is cut away, and paths are read from tokens.

use anyhow::{Context, Result};
use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use std::iter::Peekable;

/// A path as it is written: `crate::offset::raw`.
pub type Path = Vec<String>;

/// Parses a file without its code for tests.
///
/// # Errors
/// When the text is no Rust.
pub fn file(path: &str, text: &str) -> Result<syn::File> {
    let tokens: TokenStream = without_comments(text)
        .parse()
        .map_err(|e| anyhow::anyhow!("{e}"))
        .context(path.to_owned())?;
    syn::parse2(without_tests(tokens)).context(path.to_owned())
}

/// The text without lines that are comments, most of which would become attributes and cost time.
fn without_comments(text: &str) -> String {
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    code.flat_map(|line| [line, "\n"]).collect()
}

/// The tokens without whatever `#[cfg(test)]` stands before.
fn without_tests(tokens: TokenStream) -> TokenStream {
    let (mut kept, mut rest) = (Vec::new(), tokens.into_iter().peekable());
    while let Some(token) = rest.next() {
        match token {
            TokenTree::Punct(hash)
                if hash.as_char() == '#' && rest.peek().is_some_and(is_for_tests) =>
            {
                drop_attributes(&mut kept);
                skip_item(&mut rest);
            }
            TokenTree::Group(group) => kept.push(TokenTree::Group(inside_without_tests(&group))),
            other => kept.push(other),
        }
    }
    kept.into_iter().collect()
}

fn inside_without_tests(group: &Group) -> Group {
    Group::new(group.delimiter(), without_tests(group.stream()))
}

fn is_for_tests(attribute: &TokenTree) -> bool {
    let text: String = attribute.to_string().split_whitespace().collect();
    text == "[cfg(test)]" || text.starts_with("[cfg(all(test,") || text == "[test]"
}

/// Drops the attributes, comments for docs among them, at the end of the tokens.
fn drop_attributes(tokens: &mut Vec<TokenTree>) {
    while let [.., TokenTree::Punct(hash), TokenTree::Group(group)] = tokens.as_slice()
        && hash.as_char() == '#'
        && group.delimiter() == Delimiter::Bracket
    {
        tokens.truncate(tokens.len() - 2);
    }
}

/// Skips an item whose attribute comes next: up to its semicolon, its braces, or the comma of a field.
fn skip_item(rest: &mut Peekable<impl Iterator<Item = TokenTree>>) {
    let mut has_value = false;
    for token in rest {
        match token {
            TokenTree::Ident(word) => {
                has_value = word != "fn" && (has_value || is_before_value(&word))
            }
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace && !has_value => {
                return;
            }
            TokenTree::Punct(mark)
                if mark.as_char() == ';' || mark.as_char() == ',' && !has_value =>
            {
                return;
            }
            _ => {}
        }
    }
}

/// Returns `true` for words that open an item which ends at its semicolon, whatever braces it has; `const fn` is none.
fn is_before_value(word: &Ident) -> bool {
    ["use", "const", "static", "let"].iter().any(|other| word == other)
}

/// Every path in the tokens; a name after a dot or after a type's `>` is none.
pub fn paths(tokens: TokenStream) -> Vec<Path> {
    let mut found = Vec::new();
    collect(tokens, &Path::new(), &mut found);
    found
}

/// Collects the paths of tokens; `prefix` stands before each, as before a group of `use`.
fn collect(tokens: TokenStream, prefix: &Path, found: &mut Vec<Path>) {
    let (mut path, mut before) = (prefix.clone(), Before::Start);
    for token in tokens {
        before = match (token, before) {
            (TokenTree::Ident(word), Before::Start | Before::Separator) => {
                path.push(word.to_string().trim_start_matches("r#").to_owned());
                Before::Name
            }
            (TokenTree::Ident(word), Before::Name) => {
                end(&mut path, prefix, found);
                path.push(word.to_string());
                Before::Name
            }
            (TokenTree::Ident(_), Before::Dot) => Before::Member,
            (TokenTree::Group(group), Before::Separator)
                if group.delimiter() == Delimiter::Brace =>
            {
                collect(group.stream(), &std::mem::replace(&mut path, prefix.clone()), found);
                Before::Start
            }
            (TokenTree::Group(group), _) => {
                end(&mut path, prefix, found);
                collect(group.stream(), &Path::new(), found);
                Before::Start
            }
            (TokenTree::Punct(mark), before) => match (mark.as_char(), before) {
                (':', Before::Name) => Before::Colon,
                (':', Before::Colon) => Before::Separator,
                (mark, _) => {
                    end(&mut path, prefix, found);
                    if mark == '.' || mark == '\'' || mark == ':' {
                        Before::Dot
                    } else {
                        Before::Start
                    }
                }
            },
            (TokenTree::Ident(word), _) => {
                end(&mut path, prefix, found);
                path.push(word.to_string());
                Before::Name
            }
            (TokenTree::Literal(_), _) => {
                end(&mut path, prefix, found);
                Before::Start
            }
        };
    }
    end(&mut path, prefix, found);
}

/// Token before the one that is read.
enum Before {
    /// Nothing of a path.
    Start,
    /// A name of the path.
    Name,
    /// The first colon after a name.
    Colon,
    /// `::` after a name.
    Separator,
    /// A mark after which a name is no path: a dot, a lifetime's `'`, `::` after a type.
    Dot,
    /// Such a name.
    Member,
}

fn end(path: &mut Path, prefix: &Path, found: &mut Vec<Path>) {
    if path.len() > prefix.len() {
        found.push(std::mem::replace(path, prefix.clone()));
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn check(code: &str, expected: &[&str]) {
        let kept = without_tests(code.parse().unwrap());
        let found: Vec<String> = paths(kept).iter().map(|path| path.join("::")).collect();
        assert_eq!(found, expected, "{code}");
    }

    #[test]
    fn paths_are_read_from_tokens() {
        check("crate::a::b(x, super::c)", &["crate::a::b", "x", "super::c"]);
        check(
            "use crate::{a::B, c::{d, E}};",
            &["use", "crate::a::B", "crate::c::d", "crate::c::E"],
        );
        check("a.b::<T>(c).d", &["a", "T", "c"]);
        check("Vec::<T>::new(x)", &["Vec", "T", "x"]);
        check("&'a x: m::Y", &["x", "m::Y"]);
        check("vec![$crate::m::F; 3]", &["vec", "crate::m::F"]);
    }

    #[test]
    fn code_for_tests_is_cut_away() {
        check("#[cfg(test)] mod t { a } b", &["b"]);
        check("#[cfg(test)] use a::{b, c}; d", &["d"]);
        check("/// c\n#[d] #[cfg(test)] fn a() { b } #[e] f", &["e", "f"]);
        check("#[cfg(test)] const fn a() { b } c", &["c"]);
        check("#[cfg(test)] #[allow(x)] fn f(a: b) -> c { d } e", &["e"]);
        check("struct S { #[cfg(test)] a: b, c: d }", &["struct", "S", "c", "d"]);
        check("#[cfg(unix)] a", &["cfg", "unix", "a"]);
    }
}
