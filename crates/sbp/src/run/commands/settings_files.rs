//! Settings files and the firmware of the controller.

use super::utilities::locations_line;
use crate::run::FileParameters;
use crate::run::levels;
use crate::run::questions;
use crate::run::{Arguments, Context, Stop};
use crate::syntax::table::settings_lines;
use kerf_diag::Code;
use kerf_program::{Answer, Button, Command, FileRequest, Folder, QuestionKind};

/// Saves all settings as a part file that sets them.
pub(super) fn save(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    c.settle()?;
    let name = match named(a) {
        Some(name) => name,
        None => {
            let text = "Save the settings under which name?";
            entered(c, text, "")?
        }
    };
    let head = ["'Settings of Kerf.".to_owned()];
    let locations = [
        "'Where the tool stood. It is not set by UR; copied into a part file it is, without the mark.".to_owned(),
        format!("'{}", locations_line(c)),
    ];
    let lines: Vec<String> =
        head.into_iter().chain(settings_lines(c.settings())).chain(locations).collect();
    let kept = c.host.keep_settings(&name, &(lines.join("\n") + "\n"));
    let path = kept.map_err(|e| c.refused(e))?;
    c.emit(Command::Message { text: format!("the settings are in {path}").into() });
    Ok(())
}

/// Runs a settings file.
pub(super) fn load(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    c.settle()?;
    let delete = match a.whole(1) {
        Some(delete) => delete == 1,
        None => {
            let text = "Delete the system log first?";
            let question =
                questions::question(c, QuestionKind::Msgbox, text, &[Button::No, Button::Yes]);
            c.ask(&question)? == Answer::Button(Button::Yes)
        }
    };
    let name = match named(a) {
        Some(name) => name,
        None => {
            let files = c.host.settings_files();
            let text = format!("Load which settings? {}", files.join(", "));
            entered(c, &text, files.first().map_or("", String::as_str))?
        }
    };
    if delete {
        c.host.forget_system_log().map_err(|e| c.refused(e))?;
    }
    levels::call_file(c, FileRequest { folder: Folder::Settings, name }, FileParameters::default())
}

fn named(a: &Arguments) -> Option<String> {
    a.text(0).map(|name| name.trim().to_owned()).filter(|name| !name.is_empty())
}

/// A name that the operator enters; Cancel ends the run.
fn entered(c: &mut Context<'_>, text: &str, prefill: &str) -> Result<String, Stop> {
    let typed = questions::typed(c, &questions::entry(c, text, prefill))?;
    match typed.trim() {
        "" => Err(c.fail(Code::MissingParameter, "the name of a settings file expected")),
        name => Ok(name.to_owned()),
    }
}

/// Loads firmware. Asks first, for a controller without firmware is worse than an old one.
pub(super) fn install(c: &mut Context<'_>) -> Result<(), Stop> {
    c.settle()?;
    let text = "Load the controller's firmware now? Do not cut the power meanwhile.";
    let question = questions::question(c, QuestionKind::Msgbox, text, &[Button::Yes, Button::No]);
    if c.ask(&question)? != Answer::Button(Button::Yes) {
        return Ok(());
    }
    let loaded = c.host.install_firmware().map_err(|e| c.refused(e))?;
    c.emit(Command::Print { text: format!("firmware loaded: {loaded}").into(), newline: true });
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::testing::{FakeHost, run_with};
    use crate::{Session, testing::run};
    use kerf_program::{Answer, Button};

    #[test]
    fn settings_come_back_from_their_file() {
        let ran = run("VC,.375⏎US,mine⏎VC,.5⏎UR,mine,0⏎&d=%(30)");
        assert!(ran.error.is_none(), "{:?}", ran.error);
        let kept = &ran.host.settings["mine.sbd"];
        assert!(kept.lines().any(|line| line.starts_with("VC,0.375")), "{kept}");
        assert!((ran.session.settings.cutter.diameter_mm - 9.525).abs() < 1e-9);
    }

    #[test]
    #[allow(non_snake_case)]
    fn sbp_val_va_store__in_a_settings_file() {
        let ran = run("VA,1,2,3,,,4,5,6⏎US,mine⏎VA,9,9,9,,,0,0,0⏎UR,mine,0");
        assert!(ran.error.is_none(), "{:?}", ran.error);
        let kept = &ran.host.settings["mine.sbd"];
        let line = kept.lines().find(|line| line.contains("VA,")).unwrap_or_default();
        assert_eq!(line, "'VA,1,2,3,0,0,4,5,6,0,0");
        // It is there to be copied: UR itself leaves the locations alone, a part file with the line sets them.
        let frame = |ran: &crate::testing::Ran| ran.session.frame;
        let stays = run("VA,1,2,3,,,4,5,6⏎VA,9,9,9,,,0,0,0");
        assert_eq!(frame(&ran), frame(&stays));
        let again = run(&format!("VA,9,9,9,,,0,0,0⏎{}", line.trim_start_matches('\'')));
        assert_eq!(frame(&again), frame(&run("VA,1,2,3,,,4,5,6")));
        let ran = run("VC,.375⏎US,mine⏎VC,.5⏎UR,mine,0");
        assert!((ran.session.settings.cutter.diameter_mm - 9.525).abs() < 1e-9);
    }

    #[test]
    fn the_log_is_asked_for_then_the_file() {
        let mut host = FakeHost::default();
        host.settings.insert("one.sbd".into(), "VC,1\n".into());
        host.answers = [Answer::Button(Button::Yes), Answer::Text("one".into())].into();
        let ran = run_with("UR", host, Session::default());
        assert!(ran.error.is_none(), "{:?}", ran.error);
        assert!(ran.host.log_forgotten);
        assert!(ran.host.asked[1].text.contains("one.sbd"), "{:?}", ran.host.asked);
        assert!((ran.session.settings.cutter.diameter_mm - 25.4).abs() < 1e-9);
        let ran = run("UR,no such,0");
        ran.fails_with("no such");
    }

    #[test]
    fn the_editor_is_named_and_forgotten() {
        let ran = run("UN,/usr/bin/nano");
        assert_eq!(ran.host.stored["Editor"], "/usr/bin/nano");
        assert!(!run("UN,/usr/bin/nano⏎UN").host.stored.contains_key("Editor"));
    }

    #[test]
    fn firmware_is_loaded_where_there_is_some() {
        let mut host = FakeHost { firmware: Some("4.2"), ..FakeHost::default() };
        host.answers = [Answer::Button(Button::Yes)].into();
        let ran = run_with("UI", host, Session::default());
        assert!(format!("{:?}", ran.commands).contains("firmware loaded: 4.2"));
        run("UI").fails_with("no firmware on the simulated machine");
    }
}
