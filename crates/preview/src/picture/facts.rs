//! The content of the legend, as blocks of rows; how they look is the legend's own matter.

use super::depth::DepthScale;
use super::numbers;
use super::rulers::grid_spacing;
use super::view::View;
use crate::palette::{AXIS_X, Rgb, SOFT};
use crate::scene::{Finding, Scene, ToolPath};
use kerf_diag::Severity;
use std::collections::BTreeMap;

/// Tool paths and findings listed before the rest is only counted.
const MOST_LISTED: usize = 8;
/// The same where the list can be scrolled.
const MOST_ON_A_PAGE: usize = 200;

/// A sample of a line or sign with what it means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sample {
    /// A cut.
    Cut,
    /// A cut of one colour, perhaps with the width of its cutter.
    Coloured(Rgb, bool),
    /// Drilled places of one colour.
    Drilled(Rgb),
    /// Beginning of a cut.
    Begin,
    /// The bounds of all cuts.
    Bounds,
    /// A cut above the surface.
    Air,
    /// The width of the cutter.
    Cutter,
    /// A jog.
    Jog,
    /// A straight plunge.
    Plunge,
    /// Direction.
    Arrow,
    /// Start of motion.
    Start,
    /// End of motion.
    End,
}

/// One row of the legend.
#[derive(Clone, Debug, PartialEq)]
pub enum Row {
    /// Heading of a block.
    Head(String),
    /// A name and its value.
    Pair(String, String),
    /// Four columns.
    Cells([String; 4]),
    /// A sign and its meaning.
    Key(Sample, String),
    /// The depth scale.
    Depth(DepthScale),
    /// The table with the place of the drawing.
    Map,
    /// Small text.
    Note(String, Rgb),
}

/// Rows that stay together.
pub type Block = Vec<Row>;

/// Content of the paper besides the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// Depth scale of the cuts, when there are any.
    pub depth: Option<DepthScale>,
    /// Signs used.
    pub samples: Vec<(Sample, String)>,
    /// Segments left out because they cannot be drawn.
    pub left_out: usize,
    /// Deviation of a simplified drawing, mm.
    pub tolerance_mm: Option<f64>,
}

/// All blocks in order.
pub fn blocks(scene: &Scene, view: &View, drawn: &Drawn) -> Vec<Block> {
    let mut blocks = vec![job(scene), bounds(scene)];
    blocks.extend(signs(drawn));
    blocks.extend(toolpaths(scene));
    blocks.extend(findings(scene, MOST_LISTED));
    blocks.push(sheet(scene, view, drawn));
    blocks
}

/// The blocks that do not depend on how the picture is drawn, tool paths aside.
pub fn story(scene: &Scene) -> Vec<Block> {
    let mut blocks = vec![job(scene), bounds(scene)];
    blocks.extend(findings(scene, MOST_ON_A_PAGE));
    blocks
}

fn pair(name: &str, value: impl Into<String>) -> Row {
    Row::Pair(name.into(), value.into())
}

fn job(scene: &Scene) -> Block {
    vec![
        pair("Time", numbers::duration(scene.duration_s)),
        pair("Cutting", numbers::path_length(scene.cut_mm, scene.unit)),
        pair("Jogging", numbers::path_length(scene.jog_mm, scene.unit)),
        pair("Moves", numbers::count(scene.segments.len() as u64)),
        pair("Lines executed", numbers::count(scene.lines_executed)),
        pair("Findings", finding_counts(&scene.findings)),
    ]
}

/// `none`, or `1 error, 2 warnings`.
pub fn finding_counts(findings: &[Finding]) -> String {
    let kinds =
        [(Severity::Error, "error"), (Severity::Warning, "warning"), (Severity::Note, "note")];
    let counts: Vec<String> = kinds
        .into_iter()
        .map(|(severity, name)| (findings.iter().filter(|f| f.severity == severity).count(), name))
        .filter(|(n, _)| *n > 0)
        .map(|(n, name)| format!("{n} {name}{}", if n == 1 { "" } else { "s" }))
        .collect();
    if counts.is_empty() { "none".into() } else { counts.join(", ") }
}

fn bounds(scene: &Scene) -> Block {
    let title = format!("Cutting reaches, {}", scene.unit.symbol);
    let b = &scene.bounds;
    if b.is_empty() {
        return vec![Row::Head(title), Row::Note("nothing is cut".into(), SOFT)];
    }
    let size = b.size();
    let decimals = numbers::coordinate_decimals(size[0].max(size[1]) / scene.unit.mm, scene.unit);
    let number = |mm: f64| numbers::decimal(mm, scene.unit, decimals);
    let mut rows = vec![Row::Head(title), Row::Cells(["", "from", "to", "size"].map(String::from))];
    for (i, axis) in ["X", "Y", "Z"].into_iter().enumerate() {
        rows.push(Row::Cells([axis.into(), number(b.min[i]), number(b.max[i]), number(size[i])]));
    }
    rows
}

fn signs(drawn: &Drawn) -> Option<Block> {
    let mut rows = vec![Row::Head("Key".into())];
    rows.extend(drawn.depth.map(Row::Depth));
    rows.extend(drawn.samples.iter().map(|(sample, text)| Row::Key(*sample, text.clone())));
    (rows.len() > 1).then_some(rows)
}

fn toolpaths(scene: &Scene) -> Option<Block> {
    let all = together(&scene.toolpaths);
    let mut rows = vec![Row::Head("Tool paths".into())];
    let listed = all.iter().take(MOST_LISTED);
    rows.extend(listed.map(|(name, seconds)| pair(name, numbers::duration(*seconds))));
    rows.extend(rest(all.len(), MOST_LISTED));
    (rows.len() > 1).then_some(rows)
}

/// Tool paths of one name in one row with their number, where they come again and again; else each in its own.
fn together(toolpaths: &[ToolPath]) -> Vec<(String, f64)> {
    let each = || toolpaths.iter().map(|t| (toolpath_name(t), t.seconds));
    if toolpaths.len() <= MOST_LISTED {
        return each().collect();
    }
    let mut rows: Vec<(String, f64, usize)> = Vec::new();
    let mut places = BTreeMap::new();
    for (name, seconds) in each() {
        let place = *places.entry(name.clone()).or_insert(rows.len());
        match rows.get_mut(place) {
            Some(row) => (row.1, row.2) = (row.1 + seconds, row.2 + 1),
            None => rows.push((name, seconds, 1)),
        }
    }
    let named = |(name, seconds, count): (String, f64, usize)| match count {
        1 => (name, seconds),
        _ => (format!("{name}, {count} times"), seconds),
    };
    rows.into_iter().map(named).collect()
}

fn toolpath_name(toolpath: &ToolPath) -> String {
    match (toolpath.name.as_str(), toolpath.tool.as_str()) {
        ("", "") => "unnamed".into(),
        (name, "") => name.into(),
        ("", tool) => tool.into(),
        (name, tool) => format!("{name} · {tool}"),
    }
}

fn findings(scene: &Scene, most: usize) -> Option<Block> {
    let mut rows = vec![Row::Head("Findings".into())];
    let mut sorted: Vec<&Finding> = scene.findings.iter().collect();
    sorted.sort_by_key(|f| f.severity);
    for finding in sorted.into_iter().take(most) {
        let colour = if finding.severity == Severity::Error { AXIS_X } else { SOFT };
        rows.push(Row::Note(format!("• {}", finding_text(finding)), colour));
    }
    rows.extend(rest(scene.findings.len(), most));
    (rows.len() > 1).then_some(rows)
}

/// `error, line 12: the text`.
pub fn finding_text(finding: &Finding) -> String {
    let severity = match finding.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    };
    let line = if finding.line == 0 { String::new() } else { format!(", line {}", finding.line) };
    format!("{severity}{line}: {}", finding.text)
}

fn rest(all: usize, listed: usize) -> Option<Row> {
    let more = all.saturating_sub(listed);
    (more > 0).then(|| Row::Note(format!("and {more} more"), SOFT))
}

fn sheet(scene: &Scene, view: &View, drawn: &Drawn) -> Block {
    let number = |mm: f64| numbers::short(mm, scene.unit, 3);
    let unit = scene.unit.symbol;
    let mut rows = vec![Row::Head("Sheet".into())];
    if let Some(table) = &view.table {
        let [x, y, z] = table.size_mm.map(number);
        rows.push(pair("Table", format!("{x} × {y} × {z} {unit}")));
    }
    if let Some(spacing) = grid_spacing(view) {
        rows.push(pair("Grid", format!("{} {unit}", number(spacing))));
    }
    rows.push(pair("Scale", "1 : 1"));
    if view.map {
        rows.push(Row::Map);
    }
    if let Some(tolerance) = drawn.tolerance_mm {
        let within = numbers::at_most(tolerance, scene.unit);
        rows.push(Row::Note(format!("simplified, within {within} {unit}"), SOFT));
    }
    if drawn.left_out > 0 {
        let n = numbers::count(drawn.left_out as u64);
        rows.push(Row::Note(format!("{n} moves have no place on paper"), AXIS_X));
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    fn finding(severity: Severity) -> Finding {
        Finding { severity, text: "too deep".into(), line: 3 }
    }

    #[test]
    fn findings_are_counted_by_severity() {
        assert_eq!(finding_counts(&[]), "none");
        let some = [Severity::Warning, Severity::Error, Severity::Warning].map(finding);
        assert_eq!(finding_counts(&some), "1 error, 2 warnings");
        assert_eq!(finding_text(&some[1]), "error, line 3: too deep");
    }

    #[test]
    fn long_lists_say_how_much_is_missing() {
        let toolpath = |i: usize| ToolPath {
            name: format!("p{i}"),
            tool: String::new(),
            seconds: 1.0,
            first_segment: 0,
        };
        let scene = Scene { toolpaths: (0..11).map(toolpath).collect(), ..Scene::default() };
        let block = toolpaths(&scene).expect("there are tool paths");
        assert_eq!(block.last(), Some(&Row::Note("and 3 more".into(), SOFT)));
        assert_eq!(toolpaths(&Scene::default()), None);
    }

    #[test]
    fn tool_paths_that_come_again_and_again_are_told_together() {
        let toolpath = |i: usize| ToolPath {
            name: ["red", "blue", "green"][if i == 0 { 2 } else { i % 2 }].into(),
            tool: "1".into(),
            seconds: 1.5,
            first_segment: i,
        };
        let rows = |count: usize| together(&(0..count).map(toolpath).collect::<Vec<_>>());
        let row = |name: &str, seconds: f64| (name.to_owned(), seconds);
        assert_eq!(rows(3), [row("green · 1", 1.5), row("blue · 1", 1.5), row("red · 1", 1.5)]);
        let many =
            [row("green · 1", 1.5), row("blue · 1, 5 times", 7.5), row("red · 1, 4 times", 6.0)];
        assert_eq!(rows(10), many);
    }
}
