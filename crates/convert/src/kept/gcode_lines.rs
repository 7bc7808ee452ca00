//! A G-code program as a part file.
//!
//! G-code remembers modes from line to line. They are followed in the order of the lines; where a mode
//! depends on the way the run takes, the line that needs it cannot be kept (see `gcode_modes`).
//!
//! A block is calculated before any of it is done: what is assigned in it holds from the next block on,
//! and what it asks of the tool's place is the place before it.

use super::Unkept;
use super::gcode_expressions::{asks_location, each};
use super::gcode_feed::Feed;
use super::gcode_modes::{Known, Ways};
use super::gcode_survey::Survey;
use crate::Conversion;
use kerf_gcode::tree::{Block, CommentKind, Extra, Node, PlainMove, Setting, Target, Value, Word};
use kerf_gcode::{Expr, Program};
use kerf_program::settings::LinearUnit;
use std::collections::BTreeSet;

/// Writes a G-code program with its variables.
pub(super) fn to_sbp(program: &Program, how: &Conversion) -> Result<String, Unkept> {
    let survey = Survey::of(program)?;
    let mut keeper = Keeper {
        program,
        feed: Feed::new(survey.slopes),
        survey,
        unit: how.settings.linear_unit,
        coolant: how.coolant_outputs,
        text: String::new(),
        subs: String::new(),
        sub: None,
        branches: Vec::new(),
        labels: BTreeSet::new(),
        ways: Ways::new(),
        raised: false,
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
    pub(super) survey: Survey,
    unit: LinearUnit,
    coolant: [u8; 2],
    /// Text of what is run, and the subroutines behind it.
    text: String,
    subs: String,
    /// The subroutine that is being written.
    pub(super) sub: Option<String>,
    /// The conditions around: label, and the number of the branch; 0 behind `else`.
    pub(super) branches: Vec<(String, u32)>,
    /// Labels written so far.
    pub(super) labels: BTreeSet<String>,
    /// The modes where the present line stands.
    pub(super) ways: Ways,
    /// Behind a change of tools: the tool may stand above the height that it had.
    pub(super) raised: bool,
    pub(super) feed: Feed,
    /// M2 stood outside of any condition.
    over: bool,
}

impl Keeper<'_> {
    pub(super) fn line(&mut self, text: &str) {
        let subroutine = self.sub.is_some() || text.starts_with("SUB_");
        let out = if subroutine { &mut self.subs } else { &mut self.text };
        out.push_str(text);
        out.push('\n');
    }

    pub(super) fn lines(&mut self, lines: &[String]) {
        lines.iter().for_each(|text| self.line(text));
    }

    fn whole(self, how: &Conversion) -> String {
        let (name, wrong) = match self.unit {
            LinearUnit::Inch => ("INCHES", 1),
            LinearUnit::Mm => ("MM", 0),
        };
        let title: String = how.title.lines().map(|line| format!("'{line}\n")).collect();
        let guard = format!("'UNITS: {name}\nIF %(25) = {wrong} THEN GOTO UNIT_ERROR\nSA\n");
        // Those of a file begin at zero each time, the others keep what an earlier file put there.
        let unset: String = self
            .survey
            .unset
            .iter()
            .map(|n| match n {
                ..=30 => format!("&p{n} = 0\n"),
                _ => format!("IF &p{n} = \"\" THEN &p{n} = 0\n"),
            })
            .collect();
        let feed = self.feed.subroutines().concat();
        let subs = self.subs;
        format!("{title}{guard}{unset}{}END\n{subs}{feed}UNIT_ERROR:\nC#,91\nEND\n", self.text)
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
            self.ways.modes().motion = Known::Is(Some(plain.motion));
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
        let settings = extra.map_or(&[][..], |extra| &extra.settings);
        self.lower_for(line, block)?;
        let words = self.values(line, program.words_of(block))?;
        let assigned = self.assigned(line, settings, words.is_empty())?;
        let empty = words.is_empty();
        if empty {
            self.comments(line, extra)?;
        }
        self.codes(line, &words)?;
        self.motion_of(line, &words)?;
        self.ends(&words);
        assigned.iter().for_each(|text| self.line(text));
        if !empty {
            self.comments(line, extra)?;
        }
        Ok(())
    }

    /// A block that asks where the tool is asks for the height that it had before a change of tools.
    fn lower_for(&mut self, line: u32, block: &Block) -> Result<(), Unkept> {
        let words = self.program.words_of(block);
        let computed = words.iter().filter_map(|word| match word.value {
            Value::Computed(index) => self.program.exprs.get(index as usize),
            Value::Number(_) => None,
        });
        let settings = self.program.extra_of(block).into_iter().flat_map(|extra| &extra.settings);
        let mut asks = computed.chain(settings.map(|setting| &setting.value)).map(asks_location);
        if !asks.any(|asks| asks) {
            return Ok(());
        }
        self.lower();
        let is = |word: &Word, letter: u8, code: f64| {
            word.letter == letter && word.value == Value::Number(code)
        };
        if words.iter().any(|word| is(word, b'M', 6.0)) {
            return Err(Unkept::new(line, "M6 in a block that asks where the tool is"));
        }
        Ok(())
    }

    /// The assignments of a block, to be written last; what they assign is put aside first where that
    /// could change before.
    fn assigned(
        &mut self,
        line: u32,
        settings: &[Setting],
        alone: bool,
    ) -> Result<Vec<String>, Unkept> {
        let aside = settings.len() > 1 && settings.iter().any(|s| asks_parameter(&s.value))
            || !alone && settings.iter().any(|s| asks_location(&s.value));
        let mut texts = Vec::new();
        for (n, setting) in (1..).zip(settings) {
            let words = self.words(line);
            let target = match &setting.target {
                Target::Numbered(number) => words.numbered(number)?,
                Target::Named(index) => words.named(*index)?,
            };
            if target.starts_with('(') {
                return Err(Unkept::new(line, "an assignment to where the tool is"));
            }
            let value = words.alone(&setting.value)?;
            if aside {
                self.line(&format!("&next_{n} = {value}"));
                texts.push(format!("{target} = &next_{n}"));
            } else {
                texts.push(format!("{target} = {value}"));
            }
        }
        Ok(texts)
    }

    fn comments(&mut self, line: u32, extra: Option<&Extra>) -> Result<(), Unkept> {
        for comment in extra.iter().flat_map(|extra| &extra.comments) {
            let text = comment.text.trim();
            match comment.kind {
                CommentKind::Print | CommentKind::Debug => self.print(line, text)?,
                CommentKind::Abort => {
                    return Err(Unkept::new(line, "an end of the program by ABORT"));
                }
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
                    let lines = self.feed.set(value);
                    self.lines(&lines);
                }
                b'S' => self.line(&format!("TR,{value}")),
                b'T' => self.ways.modes().tool = Known::Is(Some(value.clone())),
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
            ("0" | "1" | "2" | "3", _) => {
                self.ways.modes().motion = Known::Is(code.parse().ok());
            }
            ("20", LinearUnit::Inch) | ("21", LinearUnit::Mm) => {}
            ("17" | "40" | "49" | "54" | "80" | "90" | "94" | "64" | "61" | "91.1", _) => {
                if code == "80" {
                    self.ways.modes().motion = Known::Is(None);
                }
            }
            ("4", _) => {
                let seconds = value(b'P').unwrap_or_else(|| "0".into());
                self.line(&format!("PAUSE {seconds}"));
            }
            ("92", _) => {
                self.lower();
                // VA counts in the working frame, a block in that of the file.
                let scaled = |axis: usize| {
                    value(b"XYZ"[axis])
                        .map_or_else(String::new, |v| format!("({v}) * %({})", axis + 66))
                };
                let places = [0, 1, 2].map(scaled);
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
            "6" => self.change_tool(line)?,
            "0" | "2" | "30" => {}
            _ => return Err(Unkept::new(line, format!("M{code}"))),
        }
        Ok(())
    }

    /// Writes what comes last in a block.
    fn ends(&mut self, words: &[(u8, String)]) {
        for (_, code) in words.iter().filter(|(letter, _)| *letter == b'M') {
            match code.as_str() {
                "0" => self.line("PAUSE"),
                "2" | "30" if self.sub.is_none() && self.branches.is_empty() => self.over = true,
                "2" | "30" => {
                    self.line("END");
                    self.ways.stop();
                }
                _ => {}
            }
        }
    }
}

/// Returns `true` if an expression asks for any parameter.
fn asks_parameter(expr: &Expr) -> bool {
    let mut asks = false;
    each(expr, &mut |part| asks |= matches!(part, Expr::Numbered(_) | Expr::Named(_)));
    asks
}
