//! A beginner's first part: what would be scrap by an order, a tag or a pocket is cut otherwise, or told.

use kerf_drawing::{Drawing, Editor, script};
use kerf_toolpath::{DrawnJob, job, read, write};

fn drawn(text: &str) -> Drawing {
    let mut editor = Editor::default();
    for (_, operation) in script(text).unwrap() {
        editor.apply(&operation).unwrap();
    }
    editor.drawing
}

fn order(job: &DrawnJob) -> Vec<usize> {
    job.paths.iter().map(|path| path.from).collect()
}

fn told(text: &str) -> Vec<String> {
    job(&drawn(text)).unwrap().1.iter().map(ToString::to_string).collect()
}

/// A plate with two holes, and a plate beside it.
const PLATES: &str =
    "rect 0,0 100,100; circle 30,30 10; circle 70,70 10; rect 200,0 300,100; point 250,50";

#[test]
fn inside_is_cut_before_outside_unless_the_order_was_set_by_hand() {
    let check = |text: &str, expected: &[usize]| {
        let (made, warnings) = job(&drawn(text)).unwrap();
        assert_eq!(order(&made), expected, "{text}");
        assert_eq!(warnings, [], "{text}");
        // The order of a job is its own.
        assert_eq!(order(&read(write(&made).as_bytes()).0), expected);
    };
    check(PLATES, &[2, 3, 1, 5, 4]);
    check(&format!("{PLATES}; set black height=-18"), &[2, 3, 1, 5, 4]);
    // Scratched or followed only, nothing comes free; what is off holds nothing.
    check(&format!("{PLATES}; set black height=3"), &[1, 2, 3, 4, 5]);
    check(&format!("{PLATES}; select 1; group red; set red on=off"), &[2, 3, 5, 4]);
    check(&format!("{PLATES}; select 1; group red; set red height=3"), &[1, 2, 3, 5, 4]);
    // The rings of a pocket keep the order that clears it.
    let pocket = "rect 0,0 100,100; rect 20,20 80,80; line 45,45 45,55 55,55 55,45 close; select 2,3; \
                  pocket tool=4 depth=3 outward";
    let made = job(&drawn(pocket)).unwrap().0;
    assert_eq!(order(&made).last(), Some(&1), "the plate comes last");
    let rings = &order(&made)[..made.paths.len() - 1];
    assert!(rings.is_sorted() && rings[0] == 4, "{rings:?}");
}

#[test]
fn a_part_that_comes_free_before_its_holes_by_an_order_set_by_hand_is_told() {
    let by_hand = format!("{PLATES}; sequence 1,2,3,4,5");
    let drawing = drawn(&by_hand);
    assert_eq!(order(&job(&drawing).unwrap().0), [1, 2, 3, 4, 5]);
    let mend = "in it is cut: cut what lies inside first, with `sequence auto 0,0`";
    let expected = [
        format!("shape 1 at 0,0: it comes free before shape 2 and 1 more {mend}"),
        format!("shape 4 at 200,0: it comes free before shape 5 {mend}"),
    ];
    assert_eq!(told(&by_hand), expected);
    // A file keeps that the order was set.
    let kept = kerf_formats::rsg::read(kerf_formats::rsg::write(&drawing).as_bytes()).drawing;
    assert_eq!(order(&job(&kept).unwrap().0), [1, 2, 3, 4, 5]);
    assert_eq!(told(&format!("{PLATES}; sequence auto 0,0")), Vec::<String>::new());
}

/// Notes on the tag of a square outside of which a tool of 6 mm goes.
fn tag(words: &str) -> Vec<String> {
    told(&format!("line 50,0 100,0 100,100 0,100 0,0 close; set black offset=3 cutter=6 {words}"))
}

#[test]
fn a_tag_tells_what_it_leaves_between_the_walls() {
    let leaves = |words: &str, bridge: &str| {
        let tag_mm = words.split_whitespace().next().unwrap();
        let text =
            format!("its tag of {tag_mm} mm leaves a bridge of {bridge} mm between the walls");
        assert_eq!(tag(&format!("tag={words}")), [format!("shape 1 at 50,0: {text}")]);
    };
    leaves("11", "5.0");
    leaves("11 lead-in=3,90", "2.4");
    leaves("11 lead-in=5,90", "1.1");
    leaves("20 lead-in=5,90 lead-out=5,90", "4.0");
    let loose = |words: &str, lacks: &str, mend: &str| {
        let told = tag(words).join("; ");
        assert!(told.contains(" leaves nothing between the walls"), "{told}");
        assert!(told.contains(&format!("wider by {lacks} mm: the part is loose;")), "{told}");
        assert!(told.ends_with(mend), "{told}");
    };
    loose("tag=5", "1.0", "take a longer tag");
    loose("tag=11 lead-in=5,90 lead-out=5,90", "5.0", "take a longer tag or smaller leads");
    assert_eq!(tag("tag=0"), Vec::<String>::new());
    let shallow = tag("tag=5 height=-4").join("; ");
    assert!(shallow.contains("loose where it is cut through"), "{shallow}");
    let unknown = told("rect 0,0 50,50; set black tag=5").join("; ");
    assert!(unknown.contains("less by the width of the tool, which is not known"), "{unknown}");
    // The narrowest of a group is told, and how many parts are loose.
    let two = "rect 0,0 50,50; rect 100,0 150,50; set black offset=3 tag=5";
    let both = told(two);
    assert_eq!(both.len(), 1);
    assert!(both[0].contains("is loose; so are 1 more of the group"), "{both:?}");
    // An open line holds nothing.
    assert_eq!(told("line 0,0 100,0; set black offset=3 tag=5"), Vec::<String>::new());
}
