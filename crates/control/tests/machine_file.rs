//! The file of a machine, and what programs change of it.

use kerf_control::settings_text;
use kerf_journal::machine_file::MachineFile;
use kerf_machine::{Configuration, table};
use kerf_program::Settings;
use tempfile::tempdir;

fn after(line: &str) -> Settings {
    settings_text::read(line).unwrap()
}

#[test]
fn what_v_commands_set_stays_in_the_file() {
    let lines = [
        "VC,.375,,,2,-,20",
        "VC,,,,,+,,,,.5,.6,A,7",
        "VD,,5,1,0,2,1",
        "VN,,,,,2,2,3",
        "VS,3,1,,,6,2",
        "VR,.3,.3,,,.5,.5,,,.1,.2",
        "VL,-1,90,-2,40,-3,5",
        "VU,500,600,700",
        "VB,.2,5,.9,.4",
        "VH,,.5,10,80",
        "VP,3,50,40,4",
        "VI,2",
        "SR",
        "SW,3",
        "SO,4,-3",
    ];
    for line in lines {
        let folder = tempdir().unwrap();
        let file = MachineFile::of_data(folder.path());
        let wanted = after(line);
        assert_ne!(settings_text::write(&wanted), settings_text::write(&after("")), "{line}");
        file.keep(&Settings::default(), &wanted).unwrap();
        let text = file.text().unwrap().unwrap();
        let back = file.read(&text).unwrap().program;
        assert_eq!(settings_text::write(&back), settings_text::write(&wanted), "{line}: {text}");
    }
}

#[test]
fn comments_and_the_changes_of_others_stay() {
    let folder = tempdir().unwrap();
    let file = MachineFile::of_data(folder.path());
    let began = after("");
    file.write("# my router\n[cutter]\ndiameter_mm = 6.35 # quarter inch\n[delays]\nend_s = 4\n")
        .unwrap();
    let text = file.keep(&began, &after("VC,.375")).unwrap().unwrap();
    assert_eq!(
        text,
        "# my router\n[cutter]\ndiameter_mm = 9.525 # quarter inch\n[delays]\nend_s = 4\n"
    );
    assert_eq!(file.keep(&began, &began).unwrap().unwrap(), text, "nothing was changed");
}

#[test]
fn a_machine_is_kept_as_it_is() {
    let folder = tempdir().unwrap();
    let file = MachineFile::of_data(folder.path());
    file.write("[zpos] # mine\ntop_mm = -5\n").unwrap();
    let mut machine = file.read(&file.text().unwrap().unwrap()).unwrap();
    assert_eq!(file.keep_all(&machine).unwrap(), 0);
    (machine.zpos.top_mm, machine.delays.end_s) = (-7.5, 2.0);
    machine.program.smoothing.cut_speed_mm_s = Some(50.0);
    assert_eq!(file.keep_all(&machine).unwrap(), 3);
    let text = file.text().unwrap().unwrap();
    assert_eq!(file.read(&text).unwrap(), machine);
    assert!(text.contains("# mine") && text.contains("top_mm = -7.5"), "{text}");
}

#[test]
fn one_setting_is_kept_without_the_others_that_hold() {
    let folder = tempdir().unwrap();
    let file = MachineFile::of_data(folder.path());
    let mut machine = Configuration::default();
    (machine.zpos.top_mm, machine.zpos.surface_mm) = (-5.0, -7.0);
    let [top, surface] = ["zpos.top_mm", "zpos.surface_mm"].map(|key| table::setting(key).unwrap());
    // The file has Z top at -10: a surface above it would leave a file that nobody can read.
    let crossed = file.keep_one(surface, &machine).unwrap_err();
    assert!(crossed.to_string().starts_with("zpos.surface_mm (-7) is above"), "{crossed}");
    assert_eq!(file.text().unwrap(), None);
    file.keep_one(top, &machine).unwrap();
    let read = file.read(&file.text().unwrap().unwrap()).unwrap();
    assert_eq!((read.zpos.top_mm, read.zpos.surface_mm), (-5.0, -20.0));
}

#[test]
fn what_does_not_go_together_is_not_kept() {
    let folder = tempdir().unwrap();
    let file = MachineFile::of_data(folder.path());
    file.write("").unwrap();
    let mut wanted = Settings::default();
    wanted.limits.low.0[0] = wanted.limits.high.0[0] + 1.0;
    let error = file.keep(&Settings::default(), &wanted).unwrap_err();
    assert!(error.to_string().starts_with("limits.low is above limits.high"), "{error}");
    assert_eq!(file.text().unwrap().unwrap(), "");
}
