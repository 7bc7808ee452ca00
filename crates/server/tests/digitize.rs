//! Digitizing on the server: what the keys record becomes a shape of the job, of the drawing, or of a new job.

use crate::support::hand::Hand;
use crate::support::{Shop, Wanted, at, kept, rsm, start};
use kerf_drawing::Group;
use kerf_toolpath::DrawnJob;
use serde_json::json;

/// SIM, so much faster than the world, with the job origin at (300,200).
fn sim(rate: f64) -> (Shop, Hand) {
    let shop = start(Wanted {
        rate,
        machine: Some(("sim", |machine| machine.job.origin_mm = [300.0, 200.0])),
        ..Wanted::default()
    });
    let hand = Hand::of(&shop);
    (shop, hand)
}

/// Drives to places from the job origin and records each of them.
fn record(hand: &mut Hand, places: &[[f64; 2]]) {
    for (n, [x, y]) in places.iter().enumerate() {
        hand.keys(&format!("U20E{x}E{y}E"));
        let there = [300.0 + x, 200.0 + y];
        hand.until("the place", |page| {
            let [x, y, _] = at(page);
            (x - there[0]).hypot(y - there[1]) < 1e-6
        });
        hand.until_state("idle");
        hand.press('\r');
        hand.until("the point", |page| {
            page.shown["digitized"]["points"].as_array().is_some_and(|all| all.len() == n + 1)
        });
    }
}

const TRIANGLE: [[f64; 2]; 3] = [[0.0, 0.0], [100.0, 0.0], [0.0, 80.0]];

fn job_in(shop: &Shop, name: &str) -> DrawnJob {
    kerf_toolpath::read(&std::fs::read(shop.part(name)).unwrap()).0
}

fn previewed(hand: &mut Hand) {
    hand.until("the preview", |page| page.shown["opened"]["preview"]["state"] == "ready");
}

#[test]
fn pro_files_rsm_digitized() {
    let (shop, mut hand) = sim(20.0);
    shop.write("job.rsm", rsm("line 0,0 100,0; line 0,10 100,10").as_bytes());
    shop.write("other.sbp", b"MX,1\n");
    hand.open_file("job.rsm");
    hand.keys("U70E");
    record(&mut hand, &TRIANGLE);
    hand.keys("U9E");
    hand.shows("Shape saved", "3 in the job");
    previewed(&mut hand);
    assert_eq!(hand.shown["opened"]["added"], 1);
    assert_eq!(job_in(&shop, "job.rsm").paths.len(), 2, "the file waits until the job is saved");
    // Nothing loses it by the way.
    let open = json!({ "do": "open", "name": "other.sbp" });
    assert_eq!(hand.act(open.clone()).as_deref(), Some("state"));
    assert_eq!(hand.act(json!({ "do": "close" })).as_deref(), Some("state"));
    hand.keys("EU99E");
    hand.shows("JOB: job.rsm", "100x80mm #3");
    hand.keys("U10E");
    hand.until("the job to be saved", |page| page.shown["opened"]["added"] == 0);
    assert_eq!(hand.act(open), None);
    hand.open_file("job.rsm");
    let paths = shop.get("/api/job").json()["paths"].clone();
    assert_eq!(paths.as_array().unwrap().len(), 3);
    let last = job_in(&shop, "job.rsm").paths.pop().unwrap().shape;
    assert_eq!((last.group, last.is_closed(), last.path.vertices.len()), (Group::Black, true, 3));
}

#[test]
fn a_shape_that_was_added_to_a_job_runs_with_it_or_is_taken_back() {
    let (shop, mut hand) = sim(50.0);
    shop.write("job.rsm", rsm("line 0,0 100,0").as_bytes());
    hand.open_file("job.rsm");
    hand.keys("U70E");
    record(&mut hand, &TRIANGLE);
    hand.keys("U8E");
    hand.shows("Shape saved", "2 in the job");
    previewed(&mut hand);
    assert_eq!(hand.run(), None);
    hand.until("the shape", |page| page.shown["motion"]["line"] == 2);
    hand.until("the end of the run", |page| page.shown["job"]["ended"] == "ok");
    hand.until_state("idle");
    assert_eq!(hand.act(json!({ "do": "takeShapeBack" })), None);
    previewed(&mut hand);
    assert_eq!(
        (&hand.shown["opened"]["added"], &hand.shown["opened"]["lines"]),
        (&json!(0), &json!(1))
    );
    assert_eq!(hand.act(json!({ "do": "takeShapeBack" })).as_deref(), Some("state"));
    assert_eq!(hand.act(json!({ "do": "close" })), None);
}

#[test]
fn pro_glossary_rsm__digitized_without_a_drawing() {
    let (shop, mut hand) = sim(20.0);
    hand.keys("U70E");
    record(&mut hand, &TRIANGLE);
    hand.keys("U8E");
    hand.shows("Shape saved", "in digitized.rsm");
    let job = job_in(&shop, "digitized.rsm");
    assert_eq!((job.paths.len(), job.origin), (1, Some(kerf_geom::Point2::new(300.0, 200.0))));
    assert!(!shop.part("digitized.rsg").exists());
    assert_eq!(hand.shown["opened"]["name"], "digitized.rsm");
    // The next shape belongs to the same job.
    hand.keys("EU9E");
    hand.shows("Shape saved", "2 in the job");
}

#[test]
fn a_digitized_shape_is_drawn_and_can_be_undone() {
    let (shop, mut hand) = sim(20.0);
    let draw = |op: serde_json::Value| json!({ "do": "draw", "op": op });
    assert_eq!(hand.act(draw(json!({ "op": "do", "clauses": "circle 0,0 5" }))), None);
    hand.keys("U70E");
    record(&mut hand, &TRIANGLE);
    hand.keys("U9E");
    hand.shows("Shape saved", "2 in the drawing");
    hand.until("the drawing", |page| page.shown["drawing"]["shapes"] == 2);
    let shapes = shop.get("/api/drawing/shapes").json()["shapes"].clone();
    assert_eq!(shapes[1]["closed"], true);
    assert_eq!(shapes[1]["group"], "black");
    // Its heights too.
    hand.keys("EU12EU8E");
    hand.until("the drawing", |page| page.shown["drawing"]["shapes"] == 3);
    let shapes = shop.get("/api/drawing/shapes").json()["shapes"].clone();
    assert_eq!(shapes[2]["z"], json!([20.0, 20.0, 20.0]));
    for left in [2, 1] {
        assert_eq!(hand.act(draw(json!({ "op": "undo" }))), None);
        assert_eq!(hand.shown["drawing"]["shapes"], left);
    }
}

#[test]
fn pro_digitize_key_stop__while_the_tool_follows_the_path() {
    let (_shop, mut hand) = sim(1.0);
    hand.keys("U70E");
    record(&mut hand, &[[0.0, 0.0], [400.0, 0.0]]);
    hand.shows("Digitize: 2D Point", "Cur=2 of 2");
    hand.press('F');
    hand.until("motion", |page| at(page)[0] < 680.0);
    hand.press('P');
    hand.until_state("idle");
    let stopped = at(&hand);
    assert!(stopped[0] > 310.0 && stopped[0] < 700.0, "{stopped:?}");
    assert_eq!(hand.shown["asked"], json!(null), "nobody is asked whether it goes on");
    hand.shows("Digitize: 2D Point", "Cur=2 of 2");
    // From there the next key goes on.
    hand.press('F');
    hand.until_state("idle");
    hand.shows("Digitize: 2D Point", "Cur=1 of 2");
    assert!((at(&hand)[0] - 300.0).abs() < 1e-6);
}

#[test]
fn pages_are_told_the_points_and_what_to_look_at() {
    let (_shop, mut hand) = sim(20.0);
    assert_eq!(hand.shown["digitized"], json!(null));
    hand.keys("U70E-");
    hand.until("digitizing", |page| page.shown["digitized"]["nextArc"] == true);
    hand.press('-');
    record(&mut hand, &TRIANGLE[..2]);
    let told = hand.shown["digitized"].clone();
    assert_eq!((&told["current"], &told["bulges"]), (&json!(2), &json!([0.0])));
    assert_eq!(told["points"][1]["at"], json!([100.0, 0.0, 0.0]));
    hand.keys("U31E");
    hand.until("a look", |page| page.shown["looked"] == json!({ "number": 1, "at": "data" }));
    hand.keys("U33EU33E");
    hand.until("looks", |page| page.shown["looked"] == json!({ "number": 3, "at": "out" }));
    hand.keys("U99EE");
    hand.until("the end", |page| page.shown["digitized"].is_null());
}

#[test]
fn points_outlive_the_server() {
    let shop = kept(tempfile::tempdir().unwrap());
    let mut hand = Hand::of(&shop);
    hand.keys("U70EE");
    hand.shows("Digitize: 2D Point", "Cur=1 of 1");
    hand.keys("-");
    hand.shows("Digitize: 2D Arc", "Cur=1 of 1");
    let Shop { server, dir } = shop;
    drop((hand, server));
    let shop = kept(dir);
    let mut hand = Hand::of(&shop);
    hand.until("a word about it", |page| {
        page.shown["messages"].to_string().contains("function 70 goes on with them")
    });
    hand.keys("U70E");
    hand.until("the points", |page| {
        page.shown["digitized"]["points"].as_array().is_some_and(|all| all.len() == 1)
    });
    // Who ends digitizing is asked, and then nothing is left.
    hand.keys("U99EE");
    hand.until("the end", |page| page.shown["digitized"].is_null());
    let Shop { server, dir } = shop;
    drop((hand, server));
    assert!(!dir.path().join("data/digitized.draft").exists());
}

/// Adds a place to drill to a job of one line, ends the server without saving it, and begins another.
fn added_and_ended() -> (Shop, Hand) {
    let shop = kept(tempfile::tempdir().unwrap());
    shop.write("job.rsm", rsm("line 0,0 100,0").as_bytes());
    let mut hand = Hand::of(&shop);
    hand.open_file("job.rsm");
    hand.keys("U70EE");
    hand.shows("Digitize: 2D Point", "Cur=1 of 1");
    hand.keys("U8E");
    hand.shows("Shape saved", "2 in the job");
    assert_eq!(job_in(&shop, "job.rsm").paths.len(), 1, "the file waits until the job is saved");
    assert!(
        shop.dir.path().join("data/added.draft").exists(),
        "before anybody hears that it is saved"
    );
    let Shop { server, dir } = shop;
    drop((hand, server));
    let shop = kept(dir);
    let mut hand = Hand::of(&shop);
    hand.until("a word about it", |page| {
        page.shown["messages"].to_string().contains("job.rsm: shapes were digitized into it")
    });
    (shop, hand)
}

#[test]
fn a_shape_that_was_added_to_a_job_outlives_the_server() {
    let (shop, mut hand) = added_and_ended();
    hand.open_file("job.rsm");
    assert_eq!(
        (&hand.shown["opened"]["added"], &hand.shown["opened"]["lines"]),
        (&json!(1), &json!(2))
    );
    assert_eq!(hand.act(json!({ "do": "close" })).as_deref(), Some("state"));
    assert_eq!(hand.act(json!({ "do": "saveJob" })), None);
    assert_eq!(job_in(&shop, "job.rsm").paths.len(), 2);
    assert!(!shop.dir.path().join("data/added.draft").exists());
    assert_eq!(hand.act(json!({ "do": "close" })), None);
}

#[test]
fn a_shape_that_is_taken_back_after_the_server_began_anew_is_gone() {
    let (shop, mut hand) = added_and_ended();
    hand.open_file("job.rsm");
    assert_eq!(hand.act(json!({ "do": "takeShapeBack" })), None);
    assert!(!shop.dir.path().join("data/added.draft").exists());
    assert_eq!(hand.act(json!({ "do": "close" })), None);
    hand.open_file("job.rsm");
    assert_eq!(
        (&hand.shown["opened"]["added"], &hand.shown["opened"]["lines"]),
        (&json!(0), &json!(1))
    );
}

#[test]
fn a_shape_that_was_added_to_a_job_that_is_another_now_lies_beside_it() {
    let (shop, mut hand) = added_and_ended();
    let other = rsm("line 0,0 100,0; line 0,5 100,5; line 0,9 100,9");
    shop.write("job.rsm", other.as_bytes());
    hand.open_file("job.rsm");
    assert_eq!(
        (&hand.shown["opened"]["added"], &hand.shown["opened"]["lines"]),
        (&json!(0), &json!(3))
    );
    assert_eq!(job_in(&shop, "job-digitized.rsm").paths.len(), 2);
    assert!(hand.shown["messages"].to_string().contains("job-digitized.rsm"));
    assert!(!shop.dir.path().join("data/added.draft").exists());
}
