//! The lines of the program: what each kind touches in which order, and what follows from the contacts.

use super::finding::{axes, chosen};
use crate::Entries;
use crate::lines::number;

/// Subroutines of every program: `touch` in a direction, `go` a way, each told by its X, Y and Z. A way that meets something ends the program.
///
/// ```text
///  touch   ──fast──►│  ◄─clear─  ──slow──►│  ◄─clear─      go   ──fast──►   clear all the way, or the program ends
/// ```
///
/// Where the program is only drawn, a contact is taken to be one clearance away.
const SUBROUTINES: &str = "\
o<touch> sub
#<far>=#<_far>
o<drawn> if [#<_task> EQ 0]
#<far>=#<_clear>
o<drawn> endif
G91 G38.2 X[#1 * #<far>] Y[#2 * #<far>] Z[#3 * #<far>] F#<_fast>
G0 X[0 - #1 * #<_clear>] Y[0 - #2 * #<_clear>] Z[0 - #3 * #<_clear>]
G38.2 X[#1 * 2 * #<_clear>] Y[#2 * 2 * #<_clear>] Z[#3 * 2 * #<_clear>] F#<_slow>
G0 X[0 - #1 * #<_clear>] Y[0 - #2 * #<_clear>] Z[0 - #3 * #<_clear>]
G90
o<touch> endsub
o<go> sub
G91 G38.3 X[#1] Y[#2] Z[#3] F#<_fast>
G90
o<met> if [#5070 EQ 1 AND #<_task> EQ 1]
(ABORT,Something is in the way of the probe: zero is as it was.)
o<met> endif
o<go> endsub";

/// The whole program.
pub fn program(entries: &Entries<'_>) -> Vec<String> {
    let kind = entries.text("kind");
    let per_minute = |key: &str| number(60.0 * entries.number(key));
    let mut lines = vec![
        format!("(Finds: {kind}. Made by the Probe)"),
        format!("G{} G90 G94", if entries.metric() { 21 } else { 20 }),
        format!("#<_fast>={}", per_minute("fast")),
        format!("#<_slow>={}", per_minute("slow")),
        format!("#<_far>={}", number(entries.number("travel"))),
        format!("#<_clear>={}", number(entries.number("clear"))),
    ];
    lines.extend(SUBROUTINES.lines().map(str::to_owned));
    lines.extend(["#<x0>=#<_x>", "#<y0>=#<_y>", "#<z0>=#<_z>"].map(str::to_owned));
    let probe = Probe { entries, radius: entries.number("diameter") / 2.0 };
    lines.extend(probe.finds(kind));
    lines.push(format!("(PRINT,Probed: {})", probe.told(kind)));
    lines.extend(probe.sets(kind));
    lines.push("M2".to_owned());
    lines
}

/// A touch in a direction.
fn touch([x, y, z]: [f64; 3]) -> String {
    format!("o<touch> call [{x}] [{y}] [{z}]")
}

/// A guarded way.
fn go([x, y, z]: [f64; 3]) -> String {
    format!("o<go> call [{}] [{}] [{}]", number(x), number(y), number(z))
}

/// `X` or `Y` as an index.
fn index(axis: char) -> usize {
    usize::from(axis == 'Y')
}

/// The vector of so much along X or Y.
fn along(axis: char, much: f64) -> [f64; 3] {
    let mut way = [0.0; 3];
    way[index(axis)] = much;
    way
}

/// What is known of the probe.
struct Probe<'a> {
    entries: &'a Entries<'a>,
    /// Of its tip.
    radius: f64,
}

impl Probe<'_> {
    fn length(&self, key: &str) -> f64 {
        self.entries.number(key)
    }

    /// The axis of the direction, and its sign.
    fn direction(&self) -> (char, f64) {
        let text = self.entries.text("direction");
        (
            if text.starts_with('X') { 'X' } else { 'Y' },
            if text.ends_with('-') { -1.0 } else { 1.0 },
        )
    }

    /// Signs of the way from the corner into the stock, X and Y.
    fn inwards(&self) -> [f64; 2] {
        let corner = self.entries.text("corner");
        let sign = |low: bool| if low { 1.0 } else { -1.0 };
        [sign(corner.ends_with("left")), sign(corner.starts_with("front"))]
    }

    /// Touches, and the places that follow from them.
    fn finds(&self, kind: &str) -> Vec<String> {
        let (axis, sign) = self.direction();
        match kind {
            "plate" => self.top(),
            "outside-corner" => self.outside_corner(),
            "inside-corner" => {
                let [x, y] = self.inwards();
                let mut lines = self.side('X', -x);
                lines.push("G0 X#<x0>".into());
                lines.extend(self.side('Y', -y));
                lines.push("G0 Y#<y0>".into());
                lines
            }
            "edge" => self.side(axis, sign),
            "bore" => [self.within('X'), self.within('Y')].concat(),
            "boss" => [self.across('X'), self.across('Y')].concat(),
            "slot" => self.within(axis),
            _ => self.angle(axis, sign),
        }
    }

    /// The surface below the tool.
    fn top(&self) -> Vec<String> {
        let plate = number(self.length("plate"));
        vec![touch([0.0, 0.0, -1.0]), format!("#<z>=[#5063 - {plate}]")]
    }

    /// An upright surface: the tip touches it with its radius.
    fn side(&self, axis: char, sign: f64) -> Vec<String> {
        let at = format!("#506{}", 1 + index(axis));
        let name = axis.to_ascii_lowercase();
        vec![touch(along(axis, sign)), format!("#<{name}>=[{at} + {}]", number(sign * self.radius))]
    }

    /// The top, then each side from outside: out over it, down, touch, and back the same way.
    fn outside_corner(&self) -> Vec<String> {
        let [x, y] = self.inwards();
        let (clear, depth) = (self.length("clear"), self.length("depth"));
        let out = self.length("inset") + self.radius + clear;
        let mut lines = self.top();
        lines.push("#<z1>=#<_z>".into());
        for (axis, into) in [('X', x), ('Y', y)] {
            lines.push(go(along(axis, -into * out)));
            lines.push(go([0.0, 0.0, -(depth + clear)]));
            lines.extend(self.side(axis, into));
            lines.extend(["G0 Z#<z1>", "G0 X#<x0> Y#<y0>"].map(str::to_owned));
        }
        lines
    }

    /// Both sides of a hollow around the tool, along an axis; the tool goes to the middle.
    fn within(&self, axis: char) -> Vec<String> {
        let name = axis.to_ascii_lowercase();
        let at = format!("#506{}", 1 + index(axis));
        vec![
            touch(along(axis, 1.0)),
            format!("#<high>={at}"),
            format!("G0 {axis}#<{name}0>"),
            touch(along(axis, -1.0)),
            format!("#<low>={at}"),
            format!("#<{name}>=[[#<high> + #<low>] / 2]"),
            format!("#<size>=[#<high> - #<low> + {}]", number(2.0 * self.radius)),
            format!("G0 {axis}#<{name}>"),
        ]
    }

    /// Both sides of a post below the tool, along an axis; the tool goes over its middle.
    fn across(&self, axis: char) -> Vec<String> {
        let name = axis.to_ascii_lowercase();
        let at = format!("#506{}", 1 + index(axis));
        let out = self.length("size") / 2.0 + self.radius + self.length("inset");
        let mut lines = Vec::new();
        for (sign, end) in [(1.0, "high"), (-1.0, "low")] {
            lines.push(go(along(axis, sign * out)));
            lines.push(go([0.0, 0.0, -self.length("depth")]));
            lines.push(touch(along(axis, -sign)));
            lines.push(format!("#<{end}>={at}"));
            lines.extend(["G0 Z#<z0>".to_owned(), format!("G0 {axis}#<{name}0>")]);
        }
        lines.push(format!("#<{name}>=[[#<high> + #<low>] / 2]"));
        lines.push(format!("#<size>=[#<high> - #<low> - {}]", number(2.0 * self.radius)));
        lines.push(format!("G0 {axis}#<{name}>"));
        lines
    }

    /// Two touches of a side, and the angle of the line through them against the other axis.
    fn angle(&self, axis: char, sign: f64) -> Vec<String> {
        let other = if axis == 'X' { 'Y' } else { 'X' };
        let at = format!("#506{}", 1 + index(axis));
        let (size, name) = (self.length("size"), axis.to_ascii_lowercase());
        // A side along X that rises turns by plus; one along Y that leans to plus X turns by minus.
        let rise = if axis == 'X' { "#<first> - #<second>" } else { "#<second> - #<first>" };
        vec![
            touch(along(axis, sign)),
            format!("#<first>={at}"),
            format!("G0 {axis}#<{name}0>"),
            go(along(other, size)),
            touch(along(axis, sign)),
            format!("#<second>={at}"),
            format!("G0 {axis}#<{name}0>"),
            format!("#<angle>=ATAN[{rise}]/[{}]", number(size)),
        ]
    }

    /// Words for what was found.
    fn told(&self, kind: &str) -> String {
        let direction = self.entries.text("direction");
        let place = |axis: char| format!("{axis} %.4f#<{}>", axis.to_ascii_lowercase());
        let places: Vec<String> = axes(kind, direction).chars().map(place).collect();
        match kind {
            "angle" => "angle %.4f#<angle> degrees".to_owned(),
            "bore" | "boss" => format!("{}, diameter %.4f#<size>", places.join(" ")),
            "slot" => format!("{}, width %.4f#<size>", places.join(" ")),
            _ => places.join(" "),
        }
    }

    /// Zero of the axes that are chosen, or the turn of the coordinate system in force.
    fn sets(&self, kind: &str) -> Vec<String> {
        let asked = self.entries.text("axes");
        if kind == "angle" {
            let turn = "G10 L2 P0 R[#[5210 + 20 * #5220] + #<angle>]".to_owned();
            return if asked == "none" { Vec::new() } else { vec![turn] };
        }
        let found = axes(kind, self.entries.text("direction"));
        let words = chosen(found, asked).unwrap_or_default().chars();
        let word = |axis: char| format!(" {axis}[#<_{0}> - #<{0}>]", axis.to_ascii_lowercase());
        let words: String = words.map(word).collect();
        if words.is_empty() { Vec::new() } else { vec![format!("G10 L20 P0{words}")] }
    }
}
