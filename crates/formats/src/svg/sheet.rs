//! Style sheets: the rules of `<style>` elements, and what they say of an element.
//!
//! Read are rules with selectors of CSS 2.1: types, classes, ids, attributes and how they stand to each other. Rules
//! under conditions (`@media`) and sheets in other files are told and not read.

use roxmltree::{Document, Node};
use simplecss::{Element, PseudoClass, Selector};
use std::ops::Range;

/// The most rules of a file: each is held against each element.
const MOST_RULES: usize = 2000;

/// At-rules that change nothing of the shapes.
const HARMLESS: [&str; 5] = ["charset", "font-face", "keyframes", "-webkit-keyframes", "namespace"];

/// Byte of the file at which a sheet has a mistake, and the mistake.
pub type Wrong = (usize, String);

/// A property that is set: `fill: none`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Declaration<'a> {
    pub name: &'a str,
    pub value: &'a str,
    /// It stands above those that are not.
    pub important: bool,
}

/// Reads a list of declarations. What is none is passed over, as CSS wants it.
pub fn declarations(css: &str) -> Vec<Declaration<'_>> {
    let (bytes, mut all, mut at) = (css.as_bytes(), Vec::new(), 0);
    while at < css.len() {
        at = start_of_statement(css, at);
        let end = find(bytes, at, |byte| byte == b';').unwrap_or(css.len());
        all.extend(declaration(&css[at..end]));
        at = end + 1;
    }
    all
}

fn declaration(text: &str) -> Option<Declaration<'_>> {
    let (name, value) = text.split_once(':')?;
    let value = value.split("/*").next().unwrap_or_default().trim();
    let (value, flag) = value.rsplit_once('!').unwrap_or((value, ""));
    let important = flag.trim().eq_ignore_ascii_case("important");
    Some(Declaration { name: name.trim(), value: value.trim_end(), important })
}

/// The rules of a file.
#[derive(Clone, Debug, Default)]
pub struct Sheet<'a> {
    /// Selectors with what they declare, the weakest first.
    rules: Vec<(Selector<'a>, Vec<Declaration<'a>>)>,
}

impl<'a> Sheet<'a> {
    /// The rules of all `<style>` elements, and what of them is not read.
    pub fn of(document: &'a Document<'a>) -> (Self, Vec<Wrong>) {
        let (mut sheet, mut wrong) = (Self::default(), Vec::new());
        for node in document.descendants() {
            if node.pi().is_some_and(|pi| pi.target == "xml-stylesheet") {
                wrong
                    .push((node.range().start, "a style sheet in another file is not read".into()));
            }
            if node.tag_name().name() == "style" {
                sheet.add_element(node, &mut wrong);
            }
        }
        if sheet.rules.len() > MOST_RULES {
            sheet.rules.truncate(MOST_RULES);
            wrong.push((0, format!("more than {MOST_RULES} rules of style: the rest is not read")));
        }
        sheet.rules.sort_by_key(|(selector, _)| selector.specificity());
        (sheet, wrong)
    }

    fn add_element(&mut self, node: Node<'a, 'a>, wrong: &mut Vec<Wrong>) {
        let is_css = |kind: &str| kind.is_empty() || kind.eq_ignore_ascii_case("text/css");
        let kind = node.attribute("type").unwrap_or_default();
        if !is_css(kind) {
            wrong.push((node.range().start, format!("<style> of type `{kind}` is not read")));
            return;
        }
        for text in node.children().filter(Node::is_text) {
            let css = text.text().unwrap_or_default();
            // What stands for itself is where it is in the file; letters written as entities move it a little.
            let range = text.range();
            let cdata = range.len().saturating_sub(css.len() + "]]>".len()).min(9);
            self.add_css(css, range.start + cdata, wrong);
        }
    }

    fn add_css(&mut self, css: &'a str, at: usize, wrong: &mut Vec<Wrong>) {
        for statement in statements(css) {
            match statement {
                Statement::At(range) => wrong.extend(unread_at_rule(css, &range, at)),
                Statement::Rule { selectors, body } => {
                    let declared = declarations(&css[body]);
                    self.add_rule(css, selectors, &declared, at, wrong);
                }
                Statement::Open(from) => {
                    wrong.push((at + from, "a rule of style without its end is not read".into()));
                }
            }
        }
    }

    fn add_rule(
        &mut self,
        css: &'a str,
        selectors: Range<usize>,
        declared: &[Declaration<'a>],
        at: usize,
        wrong: &mut Vec<Wrong>,
    ) {
        let mut start = selectors.start;
        for text in css[selectors].split(',') {
            match Selector::parse(text.trim()) {
                Some(selector) => self.rules.push((selector, declared.to_vec())),
                None => {
                    let shown: String = text.trim().chars().take(40).collect();
                    let lead = text.len() - text.trim_start().len();
                    wrong.push((at + start + lead, format!("the selector `{shown}` is not read")));
                }
            }
            start += text.len() + 1;
        }
    }

    /// Returns the declarations of an element, by rules and by itself, the weakest first.
    pub fn declared(&self, node: Node<'a, 'a>) -> Vec<Declaration<'a>> {
        let of_rules = self.rules.iter().filter(|(selector, _)| selector.matches(&Held(node)));
        let mut all: Vec<_> = of_rules.flat_map(|(_, declared)| declared.iter().copied()).collect();
        all.extend(node.attribute("style").into_iter().flat_map(declarations));
        all.sort_by_key(|declaration| declaration.important);
        all
    }
}

/// A piece of a sheet, as bytes of it.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Statement {
    /// `@media print { … }`, `@import …;`.
    At(Range<usize>),
    /// `.cut, #hole { … }`.
    Rule { selectors: Range<usize>, body: Range<usize> },
    /// Beginning of something that has no end.
    Open(usize),
}

/// The pieces of a sheet. Comments within them are left to whoever reads the pieces.
fn statements(css: &str) -> Vec<Statement> {
    let (bytes, mut all, mut at) = (css.as_bytes(), Vec::new(), 0);
    loop {
        at = start_of_statement(css, at);
        let Some(first) = bytes.get(at) else { return all };
        let Some(end) = find(bytes, at, |byte| matches!(byte, b'{' | b';')) else {
            all.push(Statement::Open(at));
            return all;
        };
        let is_at = *first == b'@';
        let body = if bytes[end] == b'{' { Some(end + 1) } else { None };
        let Some(close) = body.map_or(Some(end), |body| closing(bytes, body)) else {
            all.push(Statement::Open(at));
            return all;
        };
        match body {
            _ if is_at => all.push(Statement::At(at..close)),
            Some(body) => all.push(Statement::Rule { selectors: at..end, body: body..close }),
            None => all.push(Statement::Open(at)),
        }
        at = close + 1;
    }
}

/// Past blanks, comments, what once hid sheets from old browsers, and braces too many.
fn start_of_statement(css: &str, mut at: usize) -> usize {
    loop {
        let rest = &css[at..];
        let trimmed = rest.trim_start_matches(|c: char| c.is_whitespace() || c == '}' || c == ';');
        at += rest.len() - trimmed.len();
        let marks = ["<!--", "-->"];
        if trimmed.starts_with("/*") {
            at += trimmed.find("*/").map_or(trimmed.len(), |end| end + 2);
        } else if let Some(mark) = marks.iter().find(|mark| trimmed.starts_with(**mark)) {
            at += mark.len();
        } else {
            return at;
        }
    }
}

/// The next byte of a kind outside of quotes, brackets and comments.
fn find(bytes: &[u8], from: usize, wanted: impl Fn(u8) -> bool) -> Option<usize> {
    let mut at = from;
    while let Some(byte) = bytes.get(at) {
        match byte {
            byte if wanted(*byte) => return Some(at),
            b'"' | b'\'' => at += 1 + bytes[at + 1..].iter().position(|other| other == byte)?,
            b'(' => at += bytes[at..].iter().position(|other| *other == b')')?,
            b'/' if bytes.get(at + 1) == Some(&b'*') => {
                at += 3 + bytes[at + 2..].windows(2).position(|two| two == b"*/")?;
            }
            _ => {}
        }
        at += 1;
    }
    None
}

/// Finds the end of the block whose inside begins at a place.
fn closing(bytes: &[u8], from: usize) -> Option<usize> {
    let (mut depth, mut at) = (0usize, from);
    loop {
        at = find(bytes, at, |byte| matches!(byte, b'{' | b'}'))?;
        match bytes[at] {
            b'{' => depth += 1,
            _ if depth == 0 => return Some(at),
            _ => depth -= 1,
        }
        at += 1;
    }
}

fn unread_at_rule(css: &str, range: &Range<usize>, at: usize) -> Option<Wrong> {
    let name: String = css[range.start + 1..range.end]
        .chars()
        .take_while(|c| c.is_ascii_alphanumeric() || *c == '-')
        .collect();
    let matters = !HARMLESS.contains(&name.as_str());
    matters.then(|| (at + range.start, format!("the rules of `@{name}` are not read")))
}

/// A node that selectors are held against.
struct Held<'a>(Node<'a, 'a>);

impl Element for Held<'_> {
    fn parent_element(&self) -> Option<Self> {
        self.0.parent_element().map(Held)
    }

    fn prev_sibling_element(&self) -> Option<Self> {
        self.0.prev_sibling_element().map(Held)
    }

    fn has_local_name(&self, name: &str) -> bool {
        self.0.tag_name().name() == name
    }

    fn attribute_matches(&self, name: &str, operator: simplecss::AttributeOperator) -> bool {
        self.0.attribute(name).is_some_and(|value| operator.matches(value))
    }

    fn pseudo_class_matches(&self, class: PseudoClass) -> bool {
        matches!(class, PseudoClass::FirstChild) && self.0.prev_sibling_element().is_none()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(css: &str, expected: &[&str]) {
        let piece = |statement| match statement {
            Statement::At(range) => css[range].to_owned(),
            Statement::Rule { selectors, body } => format!("{}|{}", &css[selectors], &css[body]),
            Statement::Open(from) => format!("? {}", &css[from..]),
        };
        let found: Vec<_> = statements(css).into_iter().map(piece).collect();
        assert_eq!(found, expected, "{css}");
    }

    #[test]
    fn a_sheet_falls_into_its_statements() {
        check("a{b:c}", &["a|b:c"]);
        check(" <!-- .a,\n.b { c:d; } /* {e} */ #f{} -->", &[".a,\n.b | c:d; ", "#f|"]);
        check("@import url(x;y);a{b:c}", &["@import url(x;y)", "a|b:c"]);
        check("@import 'x;y';a{b:c}", &["@import 'x;y'", "a|b:c"]);
        check("@media print{a{b:c}}d{e:f}", &["@media print{a{b:c}", "d|e:f"]);
        check("a[b='}']{c:'}'}", &["a[b='}']|c:'}'"]);
        check("a{b:c", &["? a{b:c"]);
        check("a{b:'c}", &["? a{b:'c}"]);
        check("a /* b", &["? a /* b"]);
        check("}} ;a{}", &["a|"]);
    }

    #[test]
    fn what_is_no_declaration_is_passed_over() {
        let css = "/* a:b; */ c : d e ;; f; g:url(h;i:j) !IMPORTANT; k:l /* m */ ; n:'o;p'";
        let found = declarations(css);
        let found: Vec<_> = found.iter().map(|it| (it.name, it.value, it.important)).collect();
        let expected = [
            ("c", "d e", false),
            ("g", "url(h;i:j)", true),
            ("k", "l", false),
            ("n", "'o;p'", false),
        ];
        assert_eq!(found, expected);
    }
}
