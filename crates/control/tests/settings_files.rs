//! Settings files: saved, loaded, those that come with Kerf; and the virtual tools, on a machine.

use kerf_control::{RunContext, Session};
use kerf_files::{Folders, MACHINES, MemoryDisk};
use kerf_journal::RunOptions;
use kerf_program::MoveKind;
use kerf_program::settings::LinearUnit;
use kerf_sbp::Status;
use kerf_trace::{Event, Summary};
use kerf_workspace::{Workspace, stored::Stored};
use std::path::PathBuf;

/// A machine with files in memory.
struct Shop {
    session: Session,
    workspace: Workspace,
}

impl Shop {
    fn new(files: &[(&str, &str)]) -> Self {
        let files = [&[("parts/here.txt", "")], files].concat();
        let disk = MemoryDisk::new(files.iter().map(|(name, text)| (*name, text.as_bytes())));
        let folders = Folders::new("parts".into(), vec!["custom".into()], Vec::new());
        let workspace =
            Workspace::new(Box::new(disk), folders, Stored::default(), PathBuf::from("data"));
        Self { session: Session::default(), workspace }
    }

    fn types(&mut self, line: &str) -> (Summary, Vec<Event>) {
        let mut options = RunOptions::default();
        options.program.typed = true;
        let program = kerf_sbp::read_typed("typed".into(), &format!("{line}\n"));
        let mut events: Vec<Event> = Vec::new();
        let context = RunContext {
            sink: &mut events,
            operator: &mut (),
            requests: &mut (),
            machine: kerf_control::simulated(),
        };
        let summary = self.session.run(program, options, &mut self.workspace, context);
        (summary, events)
    }

    #[track_caller]
    fn does(&mut self, line: &str) -> Vec<Event> {
        let (summary, events) = self.types(line);
        assert!(summary.error.is_none(), "{line}: {:?}", summary.error);
        events
    }
}

#[test]
fn sbp_cmd_us() {
    let mut shop = Shop::new(&[]);
    shop.does("VC,.375");
    shop.does("VS,2.5,1.25");
    shop.does("US,mine");
    let saved = shop.session.memory.settings.clone();
    shop.does("VS,1,1");
    shop.does("VC,.5");
    shop.does("UR,mine,0");
    assert_eq!(shop.session.memory.settings, saved, "exactly");
    // The file runs as a part file, too.
    let source = shop.workspace.settings_files();
    assert!(source.contains(&"mine.sbd".to_owned()), "{source:?}");
}

#[test]
fn sbp_cmd_ur_machines() {
    let names: Vec<_> = MACHINES.iter().map(|file| file.name).collect();
    for name in ["simulated-96x48.sbd", "metric-2440x1220.sbd", "desktop-24x18.sbd"] {
        assert!(names.contains(&name), "{name}");
        let mut shop = Shop::new(&[]);
        shop.does(&format!("UR,{name},0"));
        let text = MACHINES.iter().find(|file| file.name == name).unwrap().text;
        for letters in ["VL", "VU", "VS", "VR", "VP"] {
            assert!(text.lines().any(|line| line.starts_with(letters)), "{name}: {letters}");
        }
        let settings = &shop.session.memory.settings;
        let (unit, table) = (settings.linear_unit, settings.limits.high.first3());
        match name {
            "simulated-96x48.sbd" => {
                assert_eq!((unit, table[0].round()), (LinearUnit::Inch, 2438.0));
            }
            "metric-2440x1220.sbd" => assert_eq!((unit, table[1]), (LinearUnit::Mm, 1220.0)),
            _ => assert_eq!(table[0].round(), 610.0),
        }
    }
}

#[test]
fn sbp_cmd_ur() {
    let mut shop = Shop::new(&[("data/settings/own.sbd", "VC,.75\n")]);
    assert!(shop.workspace.settings_files().len() > 4);
    shop.does("UR,own,0");
    assert!((shop.session.memory.settings.cutter.diameter_mm - 19.05).abs() < 1e-9);
    let (summary, _) = shop.types("UR,none of these,0");
    assert_eq!(summary.status, Status::Failed);
    assert!(summary.error.unwrap().message.contains("simulated-96x48.sbd"), "it lists them");
}

#[test]
fn sbp_cmd_ur_clearlog() {
    let log = "data/SbSys.log";
    let mut shop = Shop::new(&[(log, "old line\n")]);
    shop.does("UR,simulated-96x48,0");
    assert_eq!(shop.workspace.data_file("SbSys.log").as_deref(), Some("old line\n"), "no: kept");
    shop.does("UR,simulated-96x48,1");
    assert_eq!(shop.workspace.data_file("SbSys.log").as_deref(), Some(""), "yes: begun anew");
}

/// Runs the Copy Machine on an object; what it wrote.
fn copied(entered: &str, body: kerf_sim::Body, closed: bool, output: &str) -> (Shop, String) {
    let mut shop = Shop::new(&[]);
    shop.does(&format!("TC, {entered}"));
    let text = shop.workspace.text("copy_machine.sbp").unwrap();
    let touch = kerf_sim::Touch { input: 1, on: !closed, body };
    let options = RunOptions { touches: vec![touch], ..RunOptions::default() };
    let program = kerf_sbp::read("copy_machine.sbp".into(), text.as_bytes());
    let mut events: Vec<Event> = Vec::new();
    let context = RunContext {
        sink: &mut events,
        operator: &mut (),
        requests: &mut (),
        machine: kerf_control::simulated(),
    };
    let summary = shop.session.run(program, options, &mut shop.workspace, context);
    assert!(summary.error.is_none(), "{:?}\n{text}", summary.error);
    let written = shop.workspace.text(output).unwrap();
    (shop, written)
}

/// Ends of the cuts of a part file, inches.
fn cuts(shop: &mut Shop, file: &str) -> Vec<[f64; 3]> {
    let to = |event: &Event| match event {
        Event::Move(made) if made.kind == kerf_program::MoveKind::Cut => {
            Some([made.to.x, made.to.y, made.to.z])
        }
        _ => None,
    };
    shop.does(&format!("FP,{file}")).iter().filter_map(to).collect()
}

#[test]
fn sbp_tool_tc() {
    // A ball of 1 inch lies with its top at Z 0, its middle at 1,1.
    let mm = |inches: f64| inches * 25.4;
    let ball = kerf_sim::Body::Sphere { centre: [mm(1.0), mm(1.0), mm(-0.5)], radius: mm(0.5) };
    let form = "pattern=3D,width=2,height=2,step=.2,safe_z=.25,lowest=-.5,output=sbp,file=ball";
    let (mut shop, _) = copied(form, ball, false, "ball.sbp");
    let points = cuts(&mut shop, "ball.sbp");
    assert_eq!(points.len(), 121, "11 rows of 11");
    let mut felt = 0;
    for [x, y, z] in points {
        let r2 = 0.25 - (x - 1.0).powi(2) - (y - 1.0).powi(2);
        let surface = if r2 > 0.0 { (r2.sqrt() - 0.5).max(-0.5) } else { -0.5 };
        assert!((z - surface).abs() < 0.005, "{x},{y}: {z}, not {surface}");
        felt += usize::from(z > -0.49);
    }
    assert!(felt > 15, "{felt} points on the ball");

    // The outline of a post at half its height; the probe's contact opens.
    let post = kerf_sim::Body::Cylinder {
        centre: [mm(3.0), mm(2.0)],
        radius: mm(0.75),
        z: [mm(-1.0), 0.0],
    };
    let form =
        "pattern=2D,x=2.8,y=2.1,radius=1.5,points=36,lowest=-.5,probe=normally closed,file=post";
    let near = |x: f64, y: f64| ((x - 3.0).hypot(y - 2.0) - 0.75).abs() < 0.005;
    let (mut shop, _) = copied(&format!("{form},output=sbp,depth=.1"), post, true, "post.sbp");
    let points = cuts(&mut shop, "post.sbp");
    let outline: Vec<_> = points.iter().filter(|p| (p[2] + 0.1).abs() < 1e-6).collect();
    assert!(outline.len() >= 37 && outline.iter().all(|p| near(p[0], p[1])), "{points:?}");
    assert_eq!(outline[0][..2], outline[outline.len() - 1][..2], "it closes");

    // The same as drawings.
    for (output, kind, count) in [("dxf points", "POINT", 36), ("dxf polyline", "VERTEX", 36)] {
        let (_, text) = copied(&format!("{form},output={output}"), post, true, "post.dxf");
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.iter().filter(|line| **line == kind).count(), count, "{text}");
        let read = |code: &str| -> Vec<f64> {
            let pairs = lines.chunks_exact(2).filter(|pair| pair[0] == code);
            pairs.map(|pair| pair[1].parse().unwrap()).collect()
        };
        let (xs, ys) = (read("10"), read("20"));
        assert!(xs.len() == count && xs.iter().zip(&ys).all(|(x, y)| near(*x, *y)), "{text}");
        let opened =
            kerf_formats::dxf::read(text.as_bytes(), &kerf_formats::dxf::Options::default());
        let length: f64 = opened.drawing.shapes.iter().map(|shape| shape.path.length()).sum();
        let round = mm(0.75) * std::f64::consts::TAU;
        let outline = output == "dxf polyline";
        assert!(!outline || (length - round).abs() < 0.01 * round, "{length}, not {round}");
    }
}

#[test]
fn sbp_tool_tt() {
    let mut shop = Shop::new(&[("data/fonts/Broken.ttf", "no font")]);
    // The stem of an I in the built-in font, an inch high, with a bit of 60 degrees.
    shop.does("TT, text=I, font=Roboto, size=1, angle=60, x=2, y=3, safe_z=.25, file=letter");
    let points = cuts(&mut shop, "letter.sbp");
    // Width of the stem: 262 of the font's 2048 units, capitals are 1456.
    let deepest = points.iter().map(|p| -p[2]).fold(0.0, f64::max);
    let half = deepest * 30f64.to_radians().tan();
    let box_of = |i: usize, pick: fn(f64, f64) -> f64, from: f64| {
        points.iter().map(|p| p[i]).fold(from, pick)
    };
    // It rises to the surface in all four corners: they are the bounds of the letter.
    let (left, right) = (box_of(0, f64::min, 99.0), box_of(0, f64::max, -99.0));
    let (bottom, top) = (box_of(1, f64::min, 99.0), box_of(1, f64::max, -99.0));
    assert!((half - (right - left) / 2.0).abs() < 0.002, "{half} of {left} to {right}");
    assert!((bottom - 3.0).abs() < 1e-3 && (top - 4.0).abs() < 1e-3, "{bottom} to {top}");
    for corner in [[left, bottom], [left, top], [right, bottom], [right, top]] {
        let there = |p: &&[f64; 3]| (p[0] - corner[0]).hypot(p[1] - corner[1]) < 1e-3;
        let at = points.iter().find(there).unwrap_or_else(|| panic!("{corner:?}: {points:?}"));
        assert!(at[2].abs() < 1e-6, "{at:?}");
    }
    // Text of several letters and lines cuts, and nothing above the surface or deeper than the widest.
    shop.does("TT, text=Kerf & Söhne|1984, font=Roboto Bold, size=.75, angle=90, file=sign");
    let points = cuts(&mut shop, "sign.sbp");
    assert!(points.len() > 300, "{}", points.len());
    assert!(points.iter().all(|p| p[2] > -0.2 && p[2] < 1e-9), "{points:?}");
    // What cannot be carved is said.
    for (line, part) in [
        ("TT, text=A, font=Nowhere Sans", "no font Nowhere Sans on this computer; there are"),
        ("TT, text=A, font=Broken", "Broken cannot be read"),
        ("TT, text=漢, font=Roboto", "Roboto has no letter '漢'"),
        ("TT, text=I, font=Roboto, size=4, deepest=.1", "the widest stroke needs"),
        ("TT, text=", "something to carve"),
    ] {
        let error = shop.types(line).0.error;
        let told = error.map(|error| error.message.clone()).unwrap_or_default();
        assert!(told.contains(part), "{line}: {told}");
    }
}

/// The circles of a part file: centre, radius and depth of each, in order.
fn circles(events: &[Event]) -> Vec<[f64; 4]> {
    let circle = |event: &Event| match event {
        Event::Arc(arc) => {
            let (x, y, to) = (arc.centre.x, arc.centre.y, arc.made.to);
            let places = [x, y, (to.x - x).hypot(to.y - y), to.z];
            Some(places.map(|place| (place * 1e4).round() / 1e4 + 0.0))
        }
        _ => None,
    };
    let mut found: Vec<_> = events.iter().filter_map(circle).collect();
    found.dedup();
    found
}

/// Ends of the straight moves of a kind.
fn straight(events: &[Event], kind: MoveKind) -> Vec<[f64; 3]> {
    let end = |event: &Event| match event {
        Event::Move(made) if made.kind == kind => {
            let to = [made.to.x, made.to.y, made.to.z];
            Some(to.map(|place| (place * 1e4).round() / 1e4 + 0.0))
        }
        _ => None,
    };
    events.iter().filter_map(end).collect()
}

#[test]
fn sbp_tool_td() {
    let mut shop = Shop::new(&[]);
    let made = |shop: &mut Shop, more: &str| {
        shop.does(&format!("TD, bit=.25, passes=2, thickness=.5, file=drilled, {more}"));
        shop.does("FP,drilled.sbp")
    };
    // The cutter goes round on .375 about 2,3 for a hole of 1, and to the bottom in two passes; a
    // hole of the bit's own diameter is drilled, as deep as is said and in two passes as well.
    let events = made(&mut shop, "holes=2 3 1; 6 3 .25 .3, safe_z=.4");
    assert!(shop.workspace.text("drilled.sbp").unwrap().contains("CP,1,2,3,I"));
    assert_eq!(circles(&events), [[2.0, 3.0, 0.375, -0.25], [2.0, 3.0, 0.375, -0.5]]);
    let cuts = straight(&events, MoveKind::Cut);
    let drilled: Vec<_> = cuts.iter().filter(|at| at[0] == 6.0 && at[2] < 0.0).collect();
    assert_eq!(drilled, [&[6.0, 3.0, -0.15], &[6.0, 3.0, -0.3]], "{cuts:?}");
    let highest = |events: &[Event]| {
        straight(events, MoveKind::Jog).iter().map(|at| at[2]).fold(f64::MIN, f64::max)
    };
    assert_eq!(highest(&events), 0.4);
    // With zero at the table everything stands higher by the thickness.
    let events = made(&mut shop, "holes=2 3 1, safe_z=.4, zero=table");
    assert_eq!(circles(&events), [[2.0, 3.0, 0.375, 0.25], [2.0, 3.0, 0.375, 0.0]]);
    assert_eq!(highest(&events), 0.9);
    // A pocket leaves nothing standing and grows from its middle: nothing comes loose.
    let events = made(&mut shop, "holes=2 3 1, pocket=yes");
    let rings = circles(&events);
    for depth in [-0.25, -0.5] {
        let radii: Vec<f64> =
            rings.iter().filter(|ring| ring[3] == depth).map(|ring| ring[2]).collect();
        assert!(radii.len() > 1 && radii.is_sorted(), "{rings:?}");
        assert_eq!(radii.last(), Some(&0.375), "{rings:?}");
        // The cutter's edge reaches the middle, and the rings overlap.
        assert!(radii[0] <= 0.125 && radii.windows(2).all(|r| r[1] - r[0] < 0.25), "{radii:?}");
    }
    // The same in millimetres; a machine that is set to inches runs nothing of it.
    let events =
        made(&mut shop, "units=mm, holes=50 75 25, bit=6, thickness=12, blank_x=600, blank_y=300");
    assert_eq!((circles(&events), straight(&events, MoveKind::Cut)), (vec![], vec![]));
    shop.does("VD,,,1");
    let events = shop.does("FP,drilled.sbp");
    let expected: [[f64; 4]; 2] = [[50.0, 75.0, 9.5, -6.0], [50.0, 75.0, 9.5, -12.0]];
    assert_eq!(circles(&events), expected);
}

#[test]
fn sbp_tool_tf() {
    let mut shop = Shop::new(&[]);
    let cuts = |shop: &mut Shop, more: &str| {
        shop.does(&format!("TF, blank_width=4, blank_length=10, spacing=1, edge=.25, {more}"));
        straight(&shop.does("FP,flutes.sbp"), MoveKind::Cut)
    };
    // Four of them, evenly placed: each to and fro between the edge distances, half as deep the first
    // time. A ball of .5 makes a flute of .5 at the depth of its radius.
    let flute = |y: f64| [[0.25, y, -0.125], [9.75, y, -0.125], [9.75, y, -0.25], [0.25, y, -0.25]];
    let expected: Vec<_> = [0.5, 1.5, 2.5, 3.5].into_iter().flat_map(flute).collect();
    assert_eq!(cuts(&mut shop, "width=.5, passes=2"), expected);
    // In one pass, with a V bit of 60°: .2 wide is .1 · √3 deep.
    let of_v = cuts(&mut shop, "width=.2, bit_type=v, v_angle=60");
    assert_eq!(of_v.len(), 8);
    assert!(of_v.iter().all(|at| (at[2] + 0.1 * 3f64.sqrt()).abs() < 1e-4), "{of_v:?}");
    // A flat bit goes as deep as is said, and across: 2 wide, on a blank that lies elsewhere.
    let more = "bit_type=flat, depth=.3, width=.5, direction=y, blank_x=3, blank_y=1";
    let first: Vec<_> = cuts(&mut shop, more).into_iter().take(2).collect();
    assert_eq!(first, [[3.5, 1.25, -0.3], [3.5, 10.75, -0.3]]);
    // In millimetres it is nothing for a machine that is set to inches.
    let metric =
        "units=mm, width=10, bit=10, spacing=20, edge=10, blank_width=100, blank_length=200";
    shop.does(&format!("TF, {metric}, table_x=2000, table_y=1000"));
    assert_eq!(straight(&shop.does("FP,flutes.sbp"), MoveKind::Cut), [[0.0; 3]; 0]);
    // What does not lie on the table is not made.
    let (summary, _) = shop.types("TF, blank_x=90, blank_length=10");
    assert!(summary.error.unwrap().message.contains("the blank does not lie on the table"));
}

#[test]
fn sbp_tool_ti() {
    let mut shop = Shop::new(&[]);
    shop.does("TI, how=turn by, angle=45");
    assert!(shop.workspace.text("indexer.sbp").unwrap().contains("MB,45"));
    shop.does("VD,,5");
    shop.does("FP,indexer.sbp");
    assert!((shop.session.memory.position.0[4] - 45.0).abs() < 1e-6);
}

#[test]
fn sbp_tool_tu() {
    let mut shop = Shop::new(&[]);
    let events = shop.does("TU, x=10, y=6, bit=2, depth=.1");
    let told = events.iter().any(|event| match event {
        Event::Message { text, .. } => text.contains("Level the Z axis"),
        _ => false,
    });
    assert!(told, "the warning");
    let events = shop.does("FP,surface.sbp");
    // Every place of the area lies within the cutter's radius of the path at the depth.
    let mut path: Vec<[f64; 2]> = Vec::new();
    for event in &events {
        if let Event::Move(made) = event
            && (made.to.z + 0.1).abs() < 1e-6
        {
            for n in 0..=20 {
                let share = f64::from(n) / 20.0;
                let at = |a: f64, b: f64| a + (b - a) * share;
                path.push([at(made.from.x, made.to.x), at(made.from.y, made.to.y)]);
            }
        }
    }
    for x in 0..=20 {
        for y in 0..=12 {
            let at = [f64::from(x) * 0.5, f64::from(y) * 0.5];
            // The corners stay round: a cutter is.
            let corner = [at[0].min(10.0 - at[0]), at[1].min(6.0 - at[1])];
            if corner[0] + corner[1] < 0.9 {
                continue;
            }
            let near = |p: &[f64; 2]| (p[0] - at[0]).hypot(p[1] - at[1]) < 1.05;
            assert!(path.iter().any(near), "{at:?} was not planed");
        }
    }
    assert!(path.iter().all(|p| p[0] > 0.9 && p[0] < 9.1), "it stays in the area");
}

#[test]
fn sbp_tool_th() {
    let mut shop = Shop::new(&[("parts/door.sbp", "MX,1\nEND\n"), ("parts/warm.sbp", "MY,2\n")]);
    shop.does("TH, file=door, contact=Ann, material=birch, before=warm.sbp");
    let text = shop.workspace.text("door.sbp").unwrap();
    assert!(text.starts_with("'Contact: Ann\n'Material: birch\nFP,warm.sbp\n"), "{text}");
    assert_eq!(shop.workspace.text("door.bak").as_deref(), Some("MX,1\nEND\n"));
    assert!(kerf_sbp::Header::read(&text).unwrap().text.contains("Ann"));
    shop.does("FP,door.sbp");
    let at = shop.session.memory.position.first3();
    assert!((at[0] - 25.4).abs() < 1e-6 && (at[1] - 50.8).abs() < 1e-6, "{at:?}");
}

#[test]
fn sbp_tool_ts() {
    let mut shop = Shop::new(&[]);
    shop.does("TS, machine=Big one, plate_input=1, plate_thickness=.25, x_input=5, x_offset=1, y_offset=2");
    // A machine that stands somewhere finds its zeros by the files that read what was recorded.
    shop.does("M3,3,4,1");
    let change = |input, at_s, on| kerf_model::Change { input, at_s, on };
    let inputs = vec![change(5, 2.0, true), change(3, 6.0, true), change(1, 16.0, true)];
    let options = RunOptions { inputs, ..RunOptions::default() };
    let program = kerf_sbp::read("home.sbp".into(), b"C3\nC2\n");
    let mut events: Vec<Event> = Vec::new();
    let context = RunContext {
        sink: &mut events,
        operator: &mut (),
        requests: &mut (),
        machine: kerf_control::simulated(),
    };
    let summary = shop.session.run(program, options, &mut shop.workspace, context);
    assert!(summary.error.is_none(), "{:?}", summary.error);
    let set: Vec<_> = events
        .iter()
        .filter_map(|event| match event {
            Event::Location { set, .. } => Some(set.clone()),
            _ => None,
        })
        .collect();
    assert_eq!(set.len(), 3, "{events:#?}");
    let near = |n: usize, axis: char, value: f64| (set[n][&axis] - value).abs() < 1e-6;
    assert!(near(0, 'x', -1.0) && near(1, 'y', -2.0) && near(2, 'z', 0.25), "{set:?}");
}

/// A shop on a real disk, whose programs may be started, with these added tools.
#[cfg(unix)]
fn shop_on_disk(folder: &std::path::Path, ini: &str) -> Shop {
    let (parts, data) = (folder.join("parts"), folder.join("data"));
    std::fs::create_dir_all(&parts).unwrap();
    std::fs::create_dir_all(&data).unwrap();
    std::fs::write(data.join("virtualtools.ini"), ini).unwrap();
    let folders = Folders::new(parts, Vec::new(), Vec::new());
    let disk = Box::new(kerf_files::RealDisk);
    let workspace = Workspace::new(disk, folders, Stored::default(), data);
    let workspace = workspace.with_shell(kerf_journal::Shell::Started);
    Shop { session: Session::default(), workspace }
}

#[cfg(unix)]
#[test]
fn sbp_tool_call_params() {
    let folder = tempfile::tempdir().unwrap();
    let ini = "[Q]\nCommand = sleep .3; echo > told.txt\n[V]\nCommand = sleep 5; echo\nWait = 0\n";
    let mut shop = shop_on_disk(folder.path(), ini);
    let told = || std::fs::read_to_string(folder.path().join("parts/told.txt")).unwrap();
    shop.does("TQ, 1500, small, 2");
    assert_eq!(told(), "1500, small, 2\n", "the file waited for it");
    shop.does("&some_value=7");
    shop.does("TQ, &some_value");
    assert_eq!(told(), "7\n");
    let began = std::time::Instant::now();
    shop.does("TV, 1");
    assert!(began.elapsed().as_secs_f64() < 4.0, "one that runs beside is not waited for");
}

#[test]
fn sbp_tool_system__built_in_and_added() {
    let ini = "[Q]\nName = Nesting\nCommand = nest\n[D]\nCommand = other\n";
    let mut shop = Shop::new(&[("data/virtualtools.ini", ini)]);
    let (added, mistakes) = kerf_workspace::virtual_tools::add_ins(&shop.workspace);
    assert_eq!((added.len(), &*added[0].name), (1, "Nesting"));
    assert_eq!(mistakes, [(4, "TD is taken".to_owned())]);
    let (summary, _) = shop.types("TQ, 1500, small, 2");
    assert!(summary.error.unwrap().message.contains("disabled"), "programs have to be allowed");
    let (summary, _) = shop.types("TX");
    assert!(summary.error.unwrap().message.contains("no such tool: TX"));
}
