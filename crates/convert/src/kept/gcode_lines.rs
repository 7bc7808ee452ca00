//! A G-code program as a part file.
//!
//! G-code remembers modes from line to line. They are followed in the order of the lines, not of the
//! run, which is what people mean when they write; comparing what both programs do finds the rest.

use super::Unkept;
use crate::Conversion;
use kerf_gcode::Program;
use kerf_gcode::tree::{Block, CommentKind, Extra, Node, PlainMove, Target, Value, Word};
use kerf_program::settings::LinearUnit;

/// Writes a G-code program with its variables.
pub(super) fn to_sbp(program: &Program, how: &Conversion) -> Result<String, Unkept> {
    let mut keeper = Keeper {
        program,
        unit: how.settings.linear_unit,
        coolant: how.coolant_outputs,
        text: String::new(),
        subs: String::new(),
        sub: None,
        branches: Vec::new(),
        motion: None,
        tool: None,
        over: false,
    };
    for line in 1..=program.line_count() {
        if !keeper.over {
            keeper.one(line)?;
        }
    }
    Ok(keeper.whole(how))
}

/// A part file while it is written.
pub(super) struct Keeper<'a> {
    pub(super) program: &'a Program,
    unit: LinearUnit,
    coolant: [u8; 2],
    /// What is run, and the subroutines behind it.
    text: String,
    subs: String,
    /// The subroutine that is being written.
    pub(super) sub: Option<String>,
    /// The conditions around: label, and the number of the branch; 0 behind `else`.
    pub(super) branches: Vec<(String, u32)>,
    /// G0 … G3.
    motion: Option<u8>,
    tool: Option<String>,
    /// M2 stood outside of any condition.
    over: bool,
}

/// The values of a block that makes a motion.
#[derive(Default)]
struct Places {
    axes: [Option<String>; 3],
    centre: [Option<String>; 2],
}

impl Keeper<'_> {
    pub(super) fn line(&mut self, text: &str) {
        let subroutine = self.sub.is_some() || text.starts_with("SUB_");
        let out = if subroutine { &mut self.subs } else { &mut self.text };
        out.push_str(text);
        out.push('\n');
    }

    fn whole(self, how: &Conversion) -> String {
        let (name, wrong) = match self.unit {
            LinearUnit::Inch => ("INCHES", 1),
            LinearUnit::Mm => ("MM", 0),
        };
        let title: String = how.title.lines().map(|line| format!("'{line}\n")).collect();
        let guard = format!("'UNITS: {name}\nIF %(25) = {wrong} THEN GOTO UNIT_ERROR\nSA\n");
        let end = "END\nUNIT_ERROR:\nC#,91\nEND\n";
        let subs = self.subs;
        format!("{title}{guard}{}END\n{subs}{}", self.text, end.trim_start_matches("END\n"))
    }

    fn one(&mut self, line: u32) -> Result<(), Unkept> {
        let program = self.program;
        match program.line(line).map(|l| l.node()) {
            Some(Node::Move) => self.literal_move(line, &program.move_of(line).unwrap_or_default()),
            Some(Node::Block(index)) => match program.blocks.get(index as usize) {
                Some(block) => self.block(line, block),
                None => Ok(()),
            },
            Some(Node::Console | Node::Bad) => Err(Unkept::new(line, "this line")),
            Some(Node::Blank | Node::Percent) | None => Ok(()),
        }
    }

    fn literal_move(&mut self, line: u32, plain: &PlainMove) -> Result<(), Unkept> {
        let words: Vec<_> =
            plain.words().map(|(letter, value)| (letter, format!("{value}"))).collect();
        if plain.motion != PlainMove::MODAL {
            self.motion = Some(plain.motion);
        }
        self.settings_before(line, &words)?;
        self.motion_of(line, &words)
    }

    fn block(&mut self, line: u32, block: &Block) -> Result<(), Unkept> {
        let program = self.program;
        if block.delete > 0 {
            return Err(Unkept::new(line, "a line that may be left out (/)"));
        }
        let extra = program.extra_of(block);
        if let Some(flow) = extra.and_then(|extra| extra.flow.as_ref()) {
            self.comments(line, extra)?;
            return self.flow(line, flow);
        }
        let words = self.values(line, program.words_of(block))?;
        let empty = words.is_empty();
        if empty {
            self.comments(line, extra)?;
        }
        self.codes(line, &words)?;
        self.motion_of(line, &words)?;
        self.ends(&words);
        for setting in extra.iter().flat_map(|extra| &extra.settings) {
            let words = self.words(line);
            let target = match &setting.target {
                Target::Numbered(number) => words.numbered(number)?,
                Target::Named(index) => words.named(*index)?,
            };
            let text = format!("{target} = {}", words.alone(&setting.value)?);
            self.line(&text);
        }
        if !empty {
            self.comments(line, extra)?;
        }
        Ok(())
    }

    fn comments(&mut self, line: u32, extra: Option<&Extra>) -> Result<(), Unkept> {
        for comment in extra.iter().flat_map(|extra| &extra.comments) {
            let text = comment.text.trim();
            match comment.kind {
                CommentKind::Print | CommentKind::Debug => self.print(line, text)?,
                _ if text.is_empty() => {}
                _ => self.line(&format!("'{text}")),
            }
        }
        Ok(())
    }

    /// Text with named parameters in it.
    fn print(&mut self, line: u32, text: &str) -> Result<(), Unkept> {
        let mut items = Vec::new();
        let mut rest = text;
        while let Some((before, behind)) = rest.split_once("#<") {
            let Some((name, after)) = behind.split_once('>') else { break };
            items.push(format!("\"{before}\""));
            items.push(self.words(line).called(&name.to_lowercase())?);
            rest = after;
        }
        items.push(format!("\"{rest}\""));
        if text.contains('"')
            || items.iter().any(|item| item.starts_with('"') && item.contains(['#', '%']))
        {
            return Err(Unkept::new(line, "what PRINT shows"));
        }
        items.retain(|item| item != "\"\"");
        let mode = if items.len() == 1 && text.contains(',') { ";" } else { "" };
        self.line(&format!("PRINT{mode} {}", items.join("; ")));
        Ok(())
    }

    /// The words of a block with their values as they are written; codes are numbers.
    fn values(&self, line: u32, words: &[Word]) -> Result<Vec<(u8, String)>, Unkept> {
        let value = |word: &Word| match word.value {
            Value::Number(n) => Ok((word.letter, format!("{n}"))),
            Value::Computed(_) if matches!(word.letter, b'G' | b'M' | b'T') => {
                Err(Unkept::new(line, "a code that is computed"))
            }
            Value::Computed(index) => {
                let expr = self.program.exprs.get(index as usize);
                let zero = kerf_gcode::Expr::Number(0.0);
                Ok((word.letter, self.words(line).value(expr.unwrap_or(&zero))?))
            }
        };
        words.iter().filter(|word| word.letter != b'N').map(value).collect()
    }

    /// Speeds and spindle, which hold for the motion of their own block.
    fn settings_before(&mut self, line: u32, words: &[(u8, String)]) -> Result<(), Unkept> {
        for (letter, value) in words {
            match letter {
                b'F' => {
                    let speed = match value.parse::<f64>() {
                        Ok(feed) => kerf_program::decimal(feed / 60.0, 6),
                        Err(_) => format!("{value} / 60"),
                    };
                    self.line(&format!("VS,{speed},{speed}"));
                }
                b'S' => self.line(&format!("TR,{value}")),
                b'T' => self.tool = Some(value.clone()),
                b'A' | b'B' | b'C' | b'U' | b'V' | b'W' => {
                    return Err(Unkept::new(line, "axes beside X, Y and Z"));
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn codes(&mut self, line: u32, words: &[(u8, String)]) -> Result<(), Unkept> {
        self.settings_before(line, words)?;
        for (letter, value) in words {
            match (letter, value.as_str()) {
                (b'G', code) => self.g_code(line, code, words)?,
                (b'M', code) => self.m_code(line, code)?,
                _ => {}
            }
        }
        Ok(())
    }

    fn g_code(&mut self, line: u32, code: &str, words: &[(u8, String)]) -> Result<(), Unkept> {
        let value = |letter: u8| words.iter().find(|(l, _)| *l == letter).map(|(_, v)| v.clone());
        match (code, self.unit) {
            ("0" | "1" | "2" | "3", _) => self.motion = code.parse().ok(),
            ("20", LinearUnit::Inch) | ("21", LinearUnit::Mm) => {}
            ("17" | "40" | "49" | "54" | "80" | "90" | "94" | "64" | "61" | "91.1", _) => {
                if code == "80" {
                    self.motion = None;
                }
            }
            ("4", _) => {
                let seconds = value(b'P').unwrap_or_else(|| "0".into());
                self.line(&format!("PAUSE {seconds}"));
            }
            ("92", _) => {
                let places = [b'X', b'Y', b'Z'].map(|letter| value(letter).unwrap_or_default());
                self.line(format!("VA,{}", places.join(",")).trim_end_matches(','));
            }
            _ => return Err(Unkept::new(line, format!("G{code}"))),
        }
        Ok(())
    }

    fn m_code(&mut self, line: u32, code: &str) -> Result<(), Unkept> {
        let [mist, flood] = self.coolant;
        match code {
            "3" => self.line("SO,1,1"),
            "5" => self.line("SO,1,0"),
            "7" if mist > 0 => self.line(&format!("SO,{mist},1")),
            "8" if flood > 0 => self.line(&format!("SO,{flood},1")),
            "9" => [mist, flood].into_iter().filter(|n| *n > 0).for_each(|n| {
                self.line(&format!("SO,{n},0"));
            }),
            "6" => {
                let tool = self.tool.clone().unwrap_or_default();
                self.line(&format!("&Tool = {tool}"));
                self.line("C9");
            }
            "0" | "2" | "30" => {}
            _ => return Err(Unkept::new(line, format!("M{code}"))),
        }
        Ok(())
    }

    /// What comes last in a block.
    fn ends(&mut self, words: &[(u8, String)]) {
        for (_, code) in words.iter().filter(|(letter, _)| *letter == b'M') {
            match code.as_str() {
                "0" => self.line("PAUSE"),
                "2" | "30" if self.sub.is_none() && self.branches.is_empty() => self.over = true,
                "2" | "30" => self.line("END"),
                _ => {}
            }
        }
    }

    fn motion_of(&mut self, line: u32, words: &[(u8, String)]) -> Result<(), Unkept> {
        let other = |(letter, value): &(u8, String)| *letter == b'G' && value == "92";
        let mut places = Places::default();
        for (letter, value) in words {
            match letter {
                b'X'..=b'Z' => places.axes[usize::from(letter - b'X')] = Some(value.clone()),
                b'I' | b'J' => places.centre[usize::from(letter - b'I')] = Some(value.clone()),
                b'R' | b'K' => return Err(Unkept::new(line, "an arc by its radius, or with K")),
                _ => {}
            }
        }
        let goes =
            places.axes.iter().any(Option::is_some) || places.centre.iter().any(Option::is_some);
        if !goes || words.iter().any(other) {
            return Ok(());
        }
        match self.motion {
            Some(0) => self.straight('J', &places.axes),
            Some(1) => self.straight('M', &places.axes),
            Some(arc @ (2 | 3)) => self.arc(arc == 2, places),
            _ => return Err(Unkept::new(line, "places without a motion")),
        }
        Ok(())
    }

    fn straight(&mut self, kind: char, axes: &[Option<String>; 3]) {
        let text = match axes {
            [Some(x), None, None] => format!("{kind}X,{x}"),
            [None, Some(y), None] => format!("{kind}Y,{y}"),
            [None, None, Some(z)] => format!("{kind}Z,{z}"),
            [x, y, z] => {
                let values = [x, y, z].map(|v| v.clone().unwrap_or_default());
                let number = if z.is_some() { 3 } else { 2 };
                format!("{kind}{number},{}", values[..number].join(","))
            }
        };
        self.line(&text);
    }

    fn arc(&mut self, clockwise: bool, places: Places) {
        let turn = if clockwise { "1" } else { "-1" };
        let [x, y, z] = places.axes;
        let [i, j] = places.centre.map(|v| v.unwrap_or_else(|| "0".into()));
        let [x, y] = [x, y].map(Option::unwrap_or_default);
        let mut text = format!("CG,,{x},{y},{i},{j},T,{turn}");
        if let Some(z) = z {
            text += &format!(",{z} - %(3),1,,,3,1");
        }
        self.line(&text);
    }
}
