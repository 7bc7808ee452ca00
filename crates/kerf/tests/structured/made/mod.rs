//! Things made by seed.

mod drawings;
mod gcode;
mod opensbp;

/// Files, and the commands that look at them; `MORE` stands for a bound.
pub struct Made {
    pub files: Vec<(&'static str, String)>,
    pub commands: Vec<String>,
}

/// Makes the files of a seed.
pub fn by_seed(seed: u64) -> Made {
    let mut dice = Dice::new(seed);
    match seed % 6 {
        0 => programs(vec![
            ("a.sbp", opensbp::program(&mut dice)),
            ("b.sbp", opensbp::program(&mut dice)),
        ]),
        1 => programs(vec![("a.nc", gcode::program(&mut dice))]),
        2 => drawing(("a.dxf", drawings::dxf(&mut dice))),
        3 => drawing(("a.svg", drawings::svg(&mut dice))),
        4 => drawing(("a.plt", drawings::hpgl(&mut dice))),
        _ => drawn(&drawings::script(&mut dice)),
    }
}

fn programs(files: Vec<(&'static str, String)>) -> Made {
    let name = files[0].0;
    let looks = ["check a MORE", "preview a -o a.svg --force MORE", "time a MORE"];
    Made { commands: looks.map(|look| look.replace(" a", &format!(" {name}"))).to_vec(), files }
}

fn drawing(file: (&'static str, String)) -> Made {
    let name = file.0;
    let commands = vec![
        format!("toolpath {name} -o out.rsm --force"),
        format!("preview {name} -o picture.svg MORE"),
    ];
    Made { files: vec![file], commands }
}

fn drawn(script: &str) -> Made {
    let commands = vec![
        format!("draw --do '{script}' -o a.rsg --force"),
        "draw a.rsg --do 'select all' -o b.rsg".into(),
    ];
    let empty = ("a.rsg", String::new());
    Made {
        files: vec![empty],
        commands: [commands, vec!["toolpath a.rsg -o out.rsm".into()]].concat(),
    }
}

/// Numbers that look thrown, the same for the same seed: splitmix64 (Steele, Lea and Flood 2014).
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ mixed >> 31
    }

    /// Below a number.
    pub fn below(&mut self, most: u64) -> u64 {
        self.next() % most
    }

    /// One of several.
    pub fn one<'a>(&mut self, of: &[&'a str]) -> &'a str {
        of[self.below(of.len() as u64) as usize]
    }

    /// A form, each `#` of which becomes a length, each `@` a count.
    pub fn filled(&mut self, form: &str) -> String {
        let mut text = String::new();
        for letter in form.chars() {
            match letter {
                '#' => text += self.length(),
                '@' => text += self.count(),
                other => text.push(other),
            }
        }
        text
    }

    fn length(&mut self) -> &'static str {
        self.one(&[
            "1",
            "2.5",
            "-3",
            "0",
            "10",
            "100",
            ".001",
            "-.0000001",
            "1000000",
            "-999999999",
            "45",
            "360",
        ])
    }

    fn count(&mut self) -> &'static str {
        self.one(&["1", "2", "3", "10", "300", "5000", "100000", "1000000000", "0", "-1"])
    }
}
