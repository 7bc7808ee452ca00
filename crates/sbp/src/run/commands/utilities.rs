//! What is shown of the running session.

use super::settings_files;
use crate::run::registry;
use crate::run::{Arguments, Context, Stop};
use crate::run::{EDITOR, LAST_ERROR, USER_VALUE};
use crate::syntax::table::act::Utility;
use crate::syntax::table::settings_lines;
use crate::syntax::{Value, format_number};
use kerf_program::{Axis, Command};

/// Carries a utility out.
pub(super) fn run(c: &mut Context<'_>, act: Utility, a: &Arguments) -> Result<(), Stop> {
    let text = match act {
        Utility::Variables => variables(c),
        Utility::Values => values(c),
        Utility::Diagnostics => {
            let text = diagnostics(c);
            let kept = format!("{text}\n\n{}\n", values(c));
            c.host.keep_problem_log(&kept).map_err(|e| c.refused(e))?;
            text
        }
        Utility::Calculator => a.value(0).map_or("nothing to calculate".into(), Value::display),
        Utility::SaveSettings => return settings_files::save(c, a),
        Utility::LoadSettings => return settings_files::load(c, a),
        Utility::Firmware => return settings_files::install(c),
        Utility::Editor => {
            let program = a.text(0).map(|name| name.trim().to_owned()).filter(|n| !n.is_empty());
            c.host.store(EDITOR, program.as_deref());
            return Ok(());
        }
    };
    c.emit(Command::Message { text: text.into() });
    Ok(())
}

fn variables(c: &Context<'_>) -> String {
    let lines = c.core.memory.variables.list().into_iter();
    let lines: Vec<_> = lines.map(|(name, v)| format!("&{name} = {}", v.display())).collect();
    if lines.is_empty() { "no variables".into() } else { lines.join("\n") }
}

/// The line that says where the tool stands, in working locations and table base coordinates.
pub(super) fn locations_line(c: &Context<'_>) -> String {
    let axes = || Axis::ALL.into_iter().take(5);
    let scaled =
        |axis: Axis, internal: f64| format_number(internal / c.settings().axis_scale(axis));
    let working = axes().map(|axis| scaled(axis, c.core.place.working()[axis]));
    let base = axes().map(|axis| scaled(axis, c.core.base_coordinate(axis, 0.0)));
    let values: Vec<String> = working.chain(base).collect();
    format!("VA,{}", values.join(","))
}

/// The values of all V commands, the part folder, the folder of logs.
fn values(c: &mut Context<'_>) -> String {
    let mut lines = settings_lines(c.settings());
    lines.push(locations_line(c));
    lines.push(format!("FS,{},{}", c.host.user_path(), c.host.file_mask()));
    lines.push(format!("'settings and logs: {}", c.host.app_path()));
    lines.join("\n")
}

fn diagnostics(c: &mut Context<'_>) -> String {
    let mut lines = vec![format!("software: {}", crate::VERSION)];
    lines.push(format!("driver: {}", c.host.driver()));
    lines.push(format!("firmware: {}", c.host.firmware()));
    let settings = c.settings();
    lines.push(format!("connection: {}", settings.driver.connection(&settings.controller)));
    lines.push(format!("port: {}", c.settings().driver.port));
    lines.push(format!("working: {}", places(c, |c, axis| c.core.place.working()[axis])));
    lines.push(format!(
        "base: {}",
        places(c, |c, axis| c.core.place.frame.base(c.core.place.position)[axis])
    ));
    let lost: Vec<String> =
        registry::lost_axes(c.host).iter().map(|axis| axis.letter().to_string()).collect();
    if !lost.is_empty() {
        lines.push(format!("position not verified: {}", lost.join(" ")));
    }
    if let Some(value) = c.host.stored(USER_VALUE) {
        lines.push(format!("{USER_VALUE}: {value}"));
    }
    if let Some(error) = c.host.stored(LAST_ERROR) {
        lines.push(format!("last error: {error}"));
    }
    let inputs = (1..=12).filter(|n| c.host.input(*n)).map(|n| n.to_string());
    lines.push(format!("inputs on: {}", list(inputs.collect())));
    let outputs = (1..=12).filter(|n| c.host.output(*n)).map(|n| n.to_string());
    lines.push(format!("outputs on: {}", list(outputs.collect())));
    lines.join("\n")
}

fn list(numbers: Vec<String>) -> String {
    if numbers.is_empty() { "none".into() } else { numbers.join(" ") }
}

/// A value of every active axis in the user's units.
fn places(c: &Context<'_>, value: impl Fn(&Context<'_>, Axis) -> f64) -> String {
    let axes = Axis::ALL.into_iter().take(usize::from(c.settings().axis_count));
    let shown = axes.map(|axis| {
        let n = kerf_program::settings::to_user(value(c, axis), c.settings().axis_scale(axis));
        format!("{} {}", axis.letter(), Value::Number(n).display())
    });
    shown.collect::<Vec<_>>().join("  ")
}

#[cfg(test)]
mod tests {
    use crate::testing::{FakeHost, run, run_with};
    use crate::{Session, VERSION};
    use kerf_program::Command;

    /// The last thing shown to the operator.
    fn shown(text: &str) -> String {
        let ran = run(text);
        assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
        let told = ran.commands.iter().rev().find_map(|c| match &c.command {
            Command::Message { text } => Some(text.to_string()),
            _ => None,
        });
        told.unwrap_or_default()
    }

    #[test]
    fn ul_lists_variables_by_name() {
        assert_eq!(shown("&b=2⏎&A=two words⏎UL"), "&A = two words\n&B = 2");
        assert_eq!(shown("&b=2⏎SL⏎UL"), "no variables");
    }

    #[test]
    fn sbp_cmd_uu_test() {
        assert_eq!(shown("UU,3 > 2"), "-1");
        assert_eq!(shown("&a=2⏎UU,&a = 3"), "0");
    }

    #[test]
    fn sbp_lang_expr_example() {
        assert_eq!(shown("UU,1.5 * SQR(4.2)/(23-12.23)"), "0.2854304");
        run("MX,1.5*SQR(4.2)/(23-12.23)").ends_at(0.285_430_4, 0.0, 0.0);
    }

    #[test]
    fn sbp_cmd_uu_vars() {
        assert_eq!(shown("&a=2⏎UU,&a*3"), "6");
        run("&a=2⏎MX,&a").ends_at(2.0, 0.0, 0.0);
        assert_eq!(shown("UU"), "nothing to calculate");
    }

    #[test]
    fn uv_shows_every_value_in_the_users_unit() {
        let text = shown("VD,,,1⏎UV");
        for line in ["VC,6.35,,,25.4,-,10,25.4,0,0,0,Z,8", "VP,152.4,2438.4", "VS,50.8,25.4", "SA"]
        {
            assert!(text.lines().any(|l| l.starts_with(line)), "{line} in\n{text}");
        }
        assert!(text.starts_with("VD,,3,1,1,2,1,0,2.54"), "units first: {text}");
    }

    #[test]
    fn ud_shows_places_and_switches() {
        let mut host = FakeHost::default();
        host.inputs[3] = true;
        let ran = run_with("ZT⏎MX,2⏎VA,5⏎SO,7,1⏎UD", host, Session::default());
        let told = format!("{:?}", ran.commands.last());
        for part in
            [VERSION, "working: X 5  Y 0", "base: X 2  Y 0", "inputs on: 3", "outputs on: 7"]
        {
            assert!(told.contains(part), "{part} in {told}");
        }
    }
}
