//! The script of a simulated machine (`--script`): what its inputs do, by time and by place.
//!
//! ```text
//!  units in
//!  input 3 on at 2.5
//!  input 1 on in box 4,4,-1 6,5,-.25        * for no bound
//!  input 1 on in sphere 2,2,-.5 .5
//!  input 1 on in cylinder 8,2 1 -1 -.25     centre, radius, bottom, top
//! ```

use crate::parse;
use kerf_model::Change;
use kerf_sim::{Body, Touch};

/// Millimetres in an inch.
const INCH_MM: f64 = 25.4;

/// Content of a script.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Script {
    /// Inputs that change at a time.
    pub changes: Vec<Change>,
    /// Inputs that change with the place of the tool.
    pub touches: Vec<Touch>,
}

impl Script {
    /// Reads a script; every line that is wrong is told, with its number.
    pub fn read(text: &str) -> Result<Self, Vec<String>> {
        let (mut script, mut wrong, mut mm) = (Self::default(), Vec::new(), 1.0);
        for (n, line) in text.lines().enumerate() {
            let line = line.split('#').next().unwrap_or_default();
            let words: Vec<&str> = line.split_whitespace().collect();
            if let Err(why) = script.statement(&words, &mut mm) {
                wrong.push(format!("line {}: {why}", n + 1));
            }
        }
        if wrong.is_empty() { Ok(script) } else { Err(wrong) }
    }

    fn statement(&mut self, words: &[&str], mm: &mut f64) -> Result<(), String> {
        match words {
            [] => {}
            ["units", "in"] => *mm = INCH_MM,
            ["units", "mm"] => *mm = 1.0,
            ["input", input, state @ ("on" | "off"), "at", at] => {
                let digit = u8::from(*state == "on");
                self.changes.push(parse::input(&format!("{input}@{at}={digit}"))?);
            }
            ["input", input, state @ ("on" | "off"), "in", body @ ..] => {
                let input = parse::input_number(input)?;
                self.touches.push(Touch { input, on: *state == "on", body: read_body(body, *mm)? });
            }
            _ => return Err(
                "'input N on|off at SECONDS', 'input N on|off in BODY' or 'units in|mm' expected"
                    .into(),
            ),
        }
        Ok(())
    }
}

fn read_body(words: &[&str], mm: f64) -> Result<Body, String> {
    match *words {
        ["box", low, high] => {
            let (low, high) = (bounds(low, mm)?, bounds(high, mm)?);
            let turned = |i: usize| low[i].zip(high[i]).is_some_and(|(low, high)| low > high);
            match (0..3).find(|i| turned(*i)) {
                Some(i) => Err(format!(
                    "the lower corner comes first: {} is the wrong way round",
                    ["X", "Y", "Z"][i]
                )),
                None => Ok(Body::Box { low, high }),
            }
        }
        ["sphere", centre, radius] => {
            Ok(Body::Sphere { centre: numbers(centre, mm)?, radius: length(radius, mm)? })
        }
        ["cylinder", centre, radius, bottom, top] => {
            let [z] = numbers(bottom, mm)?;
            let [top] = numbers(top, mm)?;
            Ok(Body::Cylinder {
                centre: numbers(centre, mm)?,
                radius: length(radius, mm)?,
                z: [z, top],
            })
        }
        _ => {
            Err("'box X,Y,Z X,Y,Z', 'sphere X,Y,Z R' or 'cylinder X,Y R BOTTOM TOP' expected"
                .into())
        }
    }
}

/// A place, `*` where there is no bound.
fn bounds(text: &str, mm: f64) -> Result<[Option<f64>; 3], String> {
    let bound = |item: &str| match item {
        "*" => Ok(None),
        item => number(item, mm).map(Some),
    };
    let all: Vec<Option<f64>> = text.split(',').map(bound).collect::<Result<_, _>>()?;
    all.try_into().map_err(|_| format!("three lengths expected, as 1,2,* , not '{text}'"))
}

fn numbers<const N: usize>(text: &str, mm: f64) -> Result<[f64; N], String> {
    let all: Vec<f64> = text.split(',').map(|item| number(item, mm)).collect::<Result<_, _>>()?;
    all.try_into().map_err(|_| format!("{N} lengths expected, not '{text}'"))
}

fn length(text: &str, mm: f64) -> Result<f64, String> {
    number(text, mm).and_then(|it| {
        if it > 0.0 { Ok(it) } else { Err(format!("a radius is more than 0, not '{text}'")) }
    })
}

fn number(text: &str, mm: f64) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().ok().filter(|it| it.is_finite());
    number.map(|it| it * mm).ok_or_else(|| format!("'{text}' is not a length"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_script_names_times_and_places() {
        let text = "# a plate\nunits in\ninput 3 on at 2.5\ninput 1 off in box 1,*,-1 2,*,0\n\
                    input 2 on in sphere 0,0,1 2\nunits mm\ninput 2 on in cylinder 1,2 3 -4 5";
        let script = Script::read(text).expect("a script");
        assert_eq!(script.changes, [Change { input: 3, at_s: 2.5, on: true }]);
        let [plate, ball, post] = script.touches[..] else { panic!("{script:?}") };
        let low = [Some(25.4), None, Some(-25.4)];
        let body = Body::Box { low, high: [Some(50.8), None, Some(0.0)] };
        assert_eq!(plate, Touch { input: 1, on: false, body });
        assert_eq!(ball.body, Body::Sphere { centre: [0.0, 0.0, 25.4], radius: 50.8 });
        assert_eq!(post.body, Body::Cylinder { centre: [1.0, 2.0], radius: 3.0, z: [-4.0, 5.0] });
    }

    #[test]
    fn every_wrong_line_is_told() {
        for (line, part) in [
            ("input 3 on", "'input N on|off at SECONDS'"),
            ("input 99 on at 1", "1 to 12"),
            ("input 3 on at soon", "number of seconds"),
            ("input 3 on in cone 1", "'box X,Y,Z X,Y,Z'"),
            ("input 3 on in box 1,2 3,4,5", "three lengths"),
            ("input 3 on in box 3,*,* 2,*,*", "X is the wrong way round"),
            ("input 3 on in sphere 1,2,3 0", "more than 0"),
            ("input 3 on in sphere 1,2,x 1", "'x' is not a length"),
        ] {
            let told = Script::read(&format!("\n{line}")).expect_err(line);
            assert!(told[0].starts_with("line 2: ") && told[0].contains(part), "{told:?}");
        }
    }
}
