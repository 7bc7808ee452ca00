//! Tabs along lines, corners, slopes and arcs (VB; rows SBP-VAL-VB-*, SBP-FILE-FP-TAB*, *-TAB).

use crate::common::{IN, ca, cc, cr, origin};
use kerf_cut::{Context, Cut, Feature, Step, Tabber};
use kerf_program::settings::Tabs;
use kerf_program::{MoveKind, Settings};

fn vb() -> Tabs {
    Settings::default().tabs
}

fn inches(place: [f64; 3]) -> [f64; 3] {
    place.map(|v| v * IN)
}

fn cut(x: f64, y: f64, z: f64) -> Step {
    Step::Line { kind: MoveKind::Cut, to: inches([x, y, z]) }
}

fn jog(x: f64, y: f64, z: f64) -> Step {
    Step::Line { kind: MoveKind::Jog, to: inches([x, y, z]) }
}

/// Sends steps through tabs with Safe-Z 1 and ends the path; the tag is the number of the step.
fn through(tabs: Tabs, from: [f64; 3], steps: &[Step]) -> Vec<(usize, Step)> {
    let mut tabber = Tabber::new(&tabs, Some(IN));
    let (mut at, mut out) = (inches(from), Vec::new());
    for (line, step) in steps.iter().enumerate() {
        tabber.push(at, *step, line, &mut out);
        at = step.to();
    }
    tabber.path_end(&mut out);
    out
}

/// Height above `z` (inches) against path length: every place where a step ends.
fn profile(from: [f64; 3], z: f64, steps: &[(usize, Step)]) -> Vec<(f64, f64)> {
    let (mut at, mut s) = (inches(from), 0.0);
    steps
        .iter()
        .map(|(_, step)| {
            let mut flat = *step;
            let (Step::Line { to, .. } | Step::Arc { to, .. }) = &mut flat;
            to[2] = at[2];
            s += flat.length(at) / IN;
            at = step.to();
            (round(s), round(at[2] / IN - z))
        })
        .collect()
}

fn round(v: f64) -> f64 {
    (v * 1e6).round() / 1e6
}

/// From where to where along the path tabs are, inclines included; each must have the full shape.
#[track_caller]
fn tabs_at(profile: &[(f64, f64)], tabs: &Tabs) -> Vec<(f64, f64)> {
    let up = round(tabs.up_mm / IN);
    let lead = tabs.lead_mm / IN;
    let mut found: Vec<(f64, f64)> = Vec::new();
    let mut before = (0.0, 0.0);
    for &(s, h) in profile {
        assert!((0.0..=up).contains(&h), "height {h} at {s}");
        if before.1 == 0.0 && h > 0.0 {
            found.push((before.0, 0.0));
        }
        if before.1 > 0.0 && h == 0.0 {
            found.last_mut().unwrap().1 = s;
        }
        if let Some(tab) = found.last().filter(|t| h > 0.0 && s < t.0 + lead) {
            // On the way up, as at a corner inside the incline.
            assert!((h - (s - tab.0) / lead * up).abs() < 1e-5, "incline at {s}");
        }
        before = (s, h);
    }
    assert_eq!(before.1, 0.0, "the path ends at its own height");
    found
}

/// A circle that tabs divide is cut by as many lines as before: each part has its share of them, rounded up.
#[test]
fn parts_of_an_arc_have_their_share_of_its_chords() {
    let circle = Step::Arc {
        centre: inches([4.0, 0.0, 0.0])[..2].try_into().unwrap(),
        sweep_rad: std::f64::consts::TAU,
        to: inches([0.0, 0.0, -0.5]),
        chords: 800,
        small: false,
    };
    let out = through(vb(), [0.0, 0.0, -0.5], &[circle]);
    assert!(out.len() > 3, "{out:?}");
    for (_, step) in out {
        let Step::Arc { sweep_rad, chords, .. } = step else { panic!("{step:?}") };
        let share = 800.0 * sweep_rad / std::f64::consts::TAU;
        assert!(
            (share - 1e-6..share + 1.0 + 1e-6).contains(&f64::from(chords)),
            "{chords}, {share}"
        );
    }
}

#[track_caller]
fn check_line(tabs: Tabs, length: f64, expected: &[(f64, f64)]) {
    let from = [0.0, 0.0, -0.5];
    let out = through(tabs, from, &[cut(length, 0.0, -0.5)]);
    assert_eq!(tabs_at(&profile(from, -0.5, &out), &tabs), expected);
}

fn last_pass(context: &Context, cut: &Cut) -> ([f64; 3], Vec<Step>) {
    let range = cut.last_pass.clone().unwrap();
    let before = cut.steps[..range.start].last().map_or(context.start, Step::to);
    (before.map(|v| v / IN), cut.steps[range].to_vec())
}

#[track_caller]
fn check_cut(result: Result<Cut, kerf_cut::CutError>, z: f64, expected: &[f64]) {
    let cut = result.unwrap();
    let (from, steps) = last_pass(&origin(), &cut);
    let out = through(vb(), from, &steps);
    let want: Vec<_> = expected.iter().map(|s| (*s, s + 2.0)).collect();
    assert_eq!(tabs_at(&profile(from, z, &out), &vb()), want);
}

#[test]
fn sbp_val_vb_next() {
    check_line(vb(), 20.0, &[(4.0, 6.0), (10.0, 12.0), (16.0, 18.0)]);
    let closer = Tabs { next_mm: 3.0 * IN, ..vb() };
    check_line(closer, 21.0, &[(3.0, 5.0), (8.0, 10.0), (13.0, 15.0), (18.0, 20.0)]);
}

/// Ends of the steps of a straight cut of this length at Z -.5.
fn ends(tabs: Tabs, length: f64) -> Vec<[f64; 3]> {
    let out = through(tabs, [0.0, 0.0, -0.5], &[cut(length, 0.0, -0.5)]);
    out.iter().map(|(_, s)| s.to().map(|v| round(v / IN))).collect()
}

#[test]
fn sbp_val_vb_up() {
    let got = ends(Tabs { up_mm: 0.15 * IN, ..vb() }, 7.0);
    assert_eq!(got[1..3], [[4.5, 0.0, -0.35], [5.5, 0.0, -0.35]]);
}

#[test]
fn sbp_val_vb_lead() {
    let (low, high) = (-0.5, -0.4);
    let want = [[4.0, low], [4.5, high], [5.5, high], [6.0, low], [7.0, low]];
    assert_eq!(ends(vb(), 7.0), want.map(|[x, z]| [x, 0.0, z]));
}

#[test]
fn sbp_val_vb_size() {
    check_line(Tabs { size_mm: 0.5 * IN, ..vb() }, 11.0, &[(4.0, 5.5), (9.5, 11.0)]);
}

#[test]
fn sbp_val_vb_number() {
    check_line(Tabs { count: Some(2), ..vb() }, 40.0, &[(4.0, 6.0), (10.0, 12.0)]);
    let mut tabber = Tabber::new(&Tabs { count: Some(1), ..vb() }, Some(IN));
    assert!(tabber.active());
    tabber.push(inches([0.0, 0.0, -0.5]), cut(6.0, 0.0, -0.5), 0, &mut Vec::new());
    assert!(!tabber.active());
}

#[test]
fn sbp_val_vb_start() {
    let tabs = Tabs { start_mm: Some(IN), ..vb() };
    check_line(tabs, 20.0, &[(1.0, 3.0), (7.0, 9.0), (13.0, 15.0)]);
}

#[test]
fn a_tab_that_does_not_fit_is_left_out_and_the_line_stays_whole() {
    check_line(vb(), 5.99, &[]);
    check_line(vb(), 6.0, &[(4.0, 6.0)]);
    let whole = cut(5.99, 0.0, -0.5);
    assert_eq!(through(vb(), [0.0, 0.0, -0.5], &[whole]), [(0, whole)]);
}

#[test]
fn a_file_pass_of_one_cut_and_jogs() {
    let steps = [cut(20.0, 0.0, -0.5), jog(20.0, 0.0, 1.0), jog(0.0, 0.0, 1.0)];
    let out = through(vb(), [0.0, 0.0, -0.5], &steps);
    let found = tabs_at(&profile([0.0, 0.0, -0.5], -0.5, &out[..13]), &vb());
    assert_eq!(found, [(4.0, 6.0), (10.0, 12.0), (16.0, 18.0)]);
    assert_eq!(out[13..], [(1, steps[1]), (2, steps[2])]);
}

#[test]
fn sbp_file_fp_tab_3d() {
    let (from, to) = ([0.0, 0.0, -0.5], [20.0, 0.0, -1.0]);
    let out = through(vb(), from, &[cut(to[0], to[1], to[2])]);
    let length = 20f64.hypot(0.5);
    for (i, s) in [4.0, 4.5, 5.5, 6.0, 10.0].into_iter().enumerate() {
        let up = [0.0, 0.1, 0.1, 0.0, 0.0][i];
        let got = out[i].1.to().map(|v| v / IN);
        let want = [20.0 * s / length, 0.0, -0.5 - 0.5 * s / length + up];
        assert!(got.iter().zip(want).all(|(g, w)| (g - w).abs() < 1e-9), "{got:?} {want:?}");
    }
}

#[test]
fn sbp_file_fp_tab_safez() {
    let square =
        |x: f64| [(x, 3.5), (x + 3.5, 3.5), (x + 3.5, 0.0), (x, 0.0)].map(|(x, y)| cut(x, y, -0.5));
    let between = |z: f64| [jog(0.0, 0.0, z), jog(9.0, 0.0, z), cut(9.0, 0.0, -0.5)];
    for (z, second) in [(1.0, vec![(4.0, 6.0), (10.0, 12.0)]), (0.5, vec![(2.0, 4.0), (8.0, 10.0)])]
    {
        let steps = [&square(0.0)[..], &between(z), &square(9.0)].concat();
        let out = through(vb(), [0.0, 0.0, -0.5], &steps);
        let first: Vec<_> = out.iter().copied().filter(|p| p.0 < 4).collect();
        let other: Vec<_> = out.iter().copied().filter(|p| p.0 > 6).collect();
        let found = tabs_at(&profile([0.0, 0.0, -0.5], -0.5, &first), &vb());
        assert_eq!(found, [(4.0, 6.0), (10.0, 12.0)], "{z}");
        // The count of 14 goes on below Safe-Z: the third tab begins at 16.
        assert_eq!(tabs_at(&profile([9.0, 0.0, -0.5], -0.5, &other), &vb()), second, "{z}");
    }
}

#[test]
fn sbp_cut_cc_tab() {
    let line = "12,T,1,0,360,-.5,2,1,1,1";
    check_cut(cc(line, &origin()), -1.0, &[4.0, 10.0, 16.0, 22.0, 28.0, 34.0]);
    let cut = cc(line, &origin()).unwrap();
    let (from, steps) = last_pass(&origin(), &cut);
    let out = through(vb(), from, &steps);
    let mut at = inches(from);
    for (_, piece) in &out {
        let Step::Arc { centre, .. } = *piece else { panic!("a tab on an arc is made of arcs") };
        for p in [at, piece.to()] {
            let radius = (p[0] - centre[0]).hypot(p[1] - centre[1]) / IN;
            assert!((radius - 6.0).abs() < 1e-9);
        }
        at = piece.to();
    }
    assert_eq!(at, inches([0.0, 0.0, -1.0]));
}

#[test]
fn sbp_cut_cr_tab() {
    check_cut(cr("10,6,T,1,4,-.5,2,1", &origin()), -1.0, &[4.0, 10.0, 16.0, 22.0, 28.0]);
}

#[test]
fn sbp_cut_ca_tab() {
    // Length of the arc: radius 12.5, swept 106.26 degrees, so 23.18: four tabs.
    check_cut(ca("20,5,T,1,0,-.5,1,1,1,1", &origin()), -0.5, &[4.0, 10.0, 16.0]);
}

#[test]
fn tabs_belong_to_the_last_pass() {
    for (cut, per_pass) in
        [(cc("12,T,1,,,-.1,3,1,1,1", &origin()), 1), (cr("6,6,T,1,4,-.1,3,1", &origin()), 4)]
    {
        let cut = cut.unwrap();
        let range = cut.last_pass.unwrap();
        assert_eq!(range.len(), per_pass);
        assert!((cut.steps[range.start].to()[2] / IN + 0.3).abs() < 1e-9);
        assert_eq!(range.end, cut.steps.len() - 1, "only the pull-up follows");
    }
}

#[test]
fn a_tab_may_cross_a_corner() {
    let from = [0.0, 0.0, -0.5];
    let out = through(vb(), from, &[cut(4.25, 0.0, -0.5), cut(4.25, 5.0, -0.5)]);
    let points: Vec<_> = out.iter().map(|(tag, s)| (s.to().map(|v| round(v / IN)), *tag)).collect();
    assert_eq!(
        points,
        [
            ([4.0, 0.0, -0.5], 0),
            ([4.25, 0.0, -0.45], 0),
            ([4.25, 0.25, -0.4], 1),
            ([4.25, 1.25, -0.4], 1),
            ([4.25, 1.75, -0.5], 1),
            ([4.25, 5.0, -0.5], 1)
        ]
    );
}

#[test]
fn tabs_without_leads_have_upright_sides() {
    let tabs = Tabs { lead_mm: 0.0, ..vb() };
    let out = through(tabs, [0.0, 0.0, -0.5], &[cut(5.0, 0.0, -0.5)]);
    let points: Vec<_> = out.iter().map(|(_, s)| s.to().map(|v| round(v / IN))).collect();
    assert_eq!(points, [[4.0, 0.0, -0.5], [4.0, 0.0, -0.4], [5.0, 0.0, -0.4], [5.0, 0.0, -0.5]]);
}

#[test]
fn steps_come_out_as_soon_as_they_are_decided() {
    let mut tabber = Tabber::new(&vb(), Some(IN));
    let mut out = Vec::new();
    let from = |x: f64| inches([x, 0.0, -0.5]);
    tabber.push(from(0.0), cut(3.0, 0.0, -0.5), 0, &mut out);
    assert_eq!(out.len(), 1, "no tab begins in it");
    tabber.push(from(3.0), cut(5.0, 0.0, -0.5), 1, &mut out);
    assert_eq!(out.len(), 1, "a tab begins in it and may not fit");
    let saved = serde_json::to_string(&tabber).unwrap();
    let mut restored: Tabber<usize> = serde_json::from_str(&saved).unwrap();
    for t in [&mut tabber, &mut restored] {
        let mut rest = Vec::new();
        t.push(from(5.0), cut(6.0, 0.0, -0.5), 2, &mut rest);
        let lines: Vec<_> = rest.iter().map(|p| p.0).collect();
        assert_eq!(lines, [1, 1, 1, 2, 2]);
    }
    assert_eq!(tabber, restored);
}

#[test]
fn an_interruption_leaves_the_begun_tab_out_and_keeps_the_count() {
    let mut tabber = Tabber::new(&vb(), Some(IN));
    let mut out = Vec::new();
    let from = |x: f64| inches([x, 0.0, -0.5]);
    tabber.push(from(0.0), cut(5.0, 0.0, -0.5), 0, &mut out);
    tabber.flush(&mut out);
    tabber.push(from(5.0), cut(20.0, 0.0, -0.5), 1, &mut out);
    tabber.path_end(&mut out);
    let found = tabs_at(&profile([0.0, 0.0, -0.5], -0.5, &out), &vb());
    assert_eq!(found, [(10.0, 12.0), (16.0, 18.0)]);
}

#[test]
fn cuts_at_or_above_safe_z_and_plunges_get_no_tabs() {
    let high = [cut(20.0, 0.0, 1.0), cut(20.0, 0.0, -0.5), cut(20.0, 3.0, -0.5)];
    let out = through(vb(), [0.0, 0.0, 1.0], &high);
    assert_eq!(out.iter().map(|p| p.1).collect::<Vec<_>>(), high);
}

#[test]
fn without_safe_z_any_jog_ends_the_path() {
    let mut tabber = Tabber::for_cut(&vb(), None);
    let mut out = Vec::new();
    let from = inches([0.0, 0.0, -0.5]);
    tabber.push(from, cut(3.0, 0.0, -0.5), (), &mut out);
    tabber.push(cut(3.0, 0.0, -0.5).to(), jog(3.0, 0.0, 0.2), (), &mut out);
    tabber.push(from, cut(4.0, 0.0, -0.5), (), &mut out);
    tabber.push(cut(4.0, 0.0, -0.5).to(), cut(6.0, 0.0, -0.5), (), &mut out);
    tabber.path_end(&mut out);
    assert_eq!(out.len(), 3 + 3, "one tab, 4 after the jog: {out:?}");
}

#[test]
fn a_cut_of_its_own_ignores_number_and_first_distance() {
    let tabs = Tabs { count: Some(0), start_mm: Some(IN), ..vb() };
    let mut tabber = Tabber::for_cut(&tabs, Some(IN));
    assert!(tabber.active());
    let mut out = Vec::new();
    tabber.push(inches([0.0, 0.0, -0.5]), cut(6.0, 0.0, -0.5), (), &mut out);
    assert_eq!(round(out[0].1.to()[0] / IN), 4.0);
}

#[test]
fn pockets_are_not_tabbed() {
    let cut = cc("4,T,1,,,-.1,1,1,1,2", &origin()).unwrap();
    assert_eq!(cut.last_pass, None);
    assert_eq!(Feature::from_number(1), Some(Feature::Tab));
    assert_eq!(Feature::from_number(5), None);
}

#[test]
fn earlier_passes_do_not_count() {
    let cut = cr("2,1,T,1,4,-.5,2,1", &origin()).unwrap();
    let pass = cut.last_pass.unwrap();
    let mut tabber = Tabber::for_cut(&Tabs { next_mm: IN, ..vb() }, Some(IN));
    let (mut at, mut out) = ([0.0; 3], Vec::new());
    for (i, step) in cut.steps.iter().enumerate() {
        if pass.contains(&i) {
            tabber.push(at, *step, i, &mut out);
        } else {
            tabber.pass_by(*step, i, &mut out);
        }
        at = step.to();
    }
    tabber.path_end(&mut out);
    let tabbed: Vec<_> = out.iter().copied().filter(|p| pass.contains(&p.0)).collect();
    let found = tabs_at(&profile([0.0, 0.0, -1.0], -1.0, &tabbed), &vb());
    assert_eq!(found, [(1.0, 3.0), (4.0, 6.0)]);
    assert_eq!(out.len() - tabbed.len(), cut.steps.len() - pass.len());
}

#[test]
fn what_is_broken_off_never_comes_out() {
    let mut tabber = Tabber::new(&vb(), Some(IN));
    let mut out = Vec::new();
    tabber.push(inches([0.0, 0.0, -0.5]), cut(5.0, 0.0, -0.5), 0, &mut out);
    tabber.drop_buffered();
    tabber.path_end(&mut out);
    assert_eq!(out, []);
    tabber.push(inches([0.0, 0.0, -0.5]), cut(6.0, 0.0, -0.5), 1, &mut out);
    assert_eq!(round(out[0].1.to()[0] / IN), 4.0);
}

#[test]
fn values_that_make_no_tabs_are_told_and_do_nothing() {
    let nothing = Tabs { next_mm: 0.0, size_mm: 0.0, lead_mm: 0.0, ..vb() };
    for (tabs, part) in [
        (Tabs { next_mm: -1.0, ..vb() }, "distance to the next tab must be positive"),
        (Tabs { size_mm: f64::NAN, ..vb() }, "size of tabs is not a usable number"),
        (Tabs { up_mm: 1e300, ..vb() }, "pull-up of tabs is not a usable number"),
        (nothing, "tabs need a length"),
    ] {
        let message = Tabber::<()>::check(&tabs).unwrap_err().to_string();
        assert!(message.contains(part), "{message}");
        assert!(!Tabber::<()>::new(&tabs, None).active());
    }
    assert_eq!(Tabber::<()>::check(&vb()), Ok(()));
}
