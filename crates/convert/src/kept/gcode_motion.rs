//! Motions of a G-code program as those of a part file, and changes of tools.

use super::Unkept;
use super::gcode_expressions::location;
use super::gcode_feed::Places;
use super::gcode_lines::Keeper;
use super::gcode_modes::Known;

impl Keeper<'_> {
    /// The owner's file changes the tool; it may leave it higher than it was.
    pub(super) fn change_tool(&mut self, line: u32) -> Result<(), Unkept> {
        let tool = match self.ways.modes().tool.clone() {
            Known::Is(Some(tool)) => tool,
            Known::Is(None) => return Err(Unkept::new(line, "M6 without a tool (T) before it")),
            Known::Depends => {
                return Err(Unkept::new(line, "M6 whose tool (T) depends on the way taken"));
            }
        };
        if !self.raised {
            self.line(&format!("&height = {}", location(2)));
        }
        self.line(&format!("&Tool = {tool}"));
        self.line("C9");
        self.raised = true;
        Ok(())
    }

    /// Brings the tool back to the height that it had before a change of tools.
    pub(super) fn lower(&mut self) {
        if std::mem::take(&mut self.raised) {
            self.line("JZ,&height");
        }
    }

    pub(super) fn motion_of(&mut self, line: u32, words: &[(u8, String)]) -> Result<(), Unkept> {
        let other = |(letter, value): &(u8, String)| *letter == b'G' && value == "92";
        let mut places = Places::default();
        for (letter, value) in words {
            match letter {
                b'X'..=b'Z' => places.axes[usize::from(letter - b'X')] = Some(value.clone()),
                b'I' | b'J' => places.centre[usize::from(letter - b'I')] = Some(value.clone()),
                b'P' if self.turns() => return Err(Unkept::new(line, "an arc of several turns")),
                b'R' | b'K' => return Err(Unkept::new(line, "an arc by its radius, or with K")),
                _ => {}
            }
        }
        let goes =
            places.axes.iter().any(Option::is_some) || places.centre.iter().any(Option::is_some);
        if !goes || words.iter().any(other) {
            return Ok(());
        }
        match self.ways.modes().motion.clone() {
            Known::Is(Some(0)) => self.jog(&places),
            Known::Is(Some(1)) => self.cut(line, &places)?,
            Known::Is(Some(arc @ (2 | 3))) => self.arc(line, arc == 2, &places)?,
            Known::Is(_) => return Err(Unkept::new(line, "places without a motion")),
            Known::Depends => {
                return Err(Unkept::new(line, "a motion (G0 to G3) that depends on the way taken"));
            }
        }
        Ok(())
    }

    /// Returns `true` if the motion in force is an arc.
    fn turns(&mut self) -> bool {
        matches!(self.ways.modes().motion, Known::Is(Some(2 | 3)))
    }

    fn jog(&mut self, places: &Places) {
        if places.axes[2].is_none() {
            self.lower();
        }
        self.raised = false;
        self.line(&straight('J', &places.axes));
    }

    fn cut(&mut self, line: u32, places: &Places) -> Result<(), Unkept> {
        self.lower();
        let text = straight('M', &places.axes);
        if matches!(places.axes, [None, None, _] | [_, _, None]) {
            self.line(&text);
            return Ok(());
        }
        let lines = self.feed.on_a_slope(line, places, None, &text)?;
        self.lines(&lines);
        Ok(())
    }

    fn arc(&mut self, line: u32, clockwise: bool, places: &Places) -> Result<(), Unkept> {
        self.lower();
        let turn = if clockwise { "1" } else { "-1" };
        let [x, y, z] = &places.axes;
        let [i, j] = [0, 1].map(|n| places.centre[n].as_deref().unwrap_or("0"));
        let [x, y] = [x, y].map(|value| value.as_deref().unwrap_or_default());
        let flat = format!("CG,,{x},{y},{i},{j},T,{turn}");
        let Some(z) = z else {
            self.line(&flat);
            return Ok(());
        };
        let helix = format!("{flat},{z} - {},1,,,3,1", location(2));
        let lines = self.feed.on_a_slope(line, places, Some(turn), &helix)?;
        self.lines(&lines);
        Ok(())
    }
}

/// A move or a jog.
fn straight(kind: char, axes: &[Option<String>; 3]) -> String {
    match axes {
        [Some(x), None, None] => format!("{kind}X,{x}"),
        [None, Some(y), None] => format!("{kind}Y,{y}"),
        [None, None, Some(z)] => format!("{kind}Z,{z}"),
        [x, y, z] => {
            let values = [x, y, z].map(|v| v.clone().unwrap_or_default());
            let number = if z.is_some() { 3 } else { 2 };
            format!("{kind}{number},{}", values[..number].join(","))
        }
    }
}
