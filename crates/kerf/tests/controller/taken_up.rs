//! A run on a controller that was cut short is taken up: nothing of the path is left out, and nothing is elsewhere.

use crate::bench::Bench;
use crate::shop::{Did, Shop};
use std::thread::sleep;
use std::time::Duration;

/// A spiral of short moves, in inches, cut a tenth deep.
fn spiral() -> (String, Vec<[f64; 2]>) {
    let place = |n: u32| {
        let (angle, radius) = (f64::from(n) * 0.05, 0.3 + 0.002 * f64::from(n));
        [radius * angle.cos(), radius * angle.sin()]
    };
    let places: Vec<[f64; 2]> = (0..260).map(place).collect();
    let [x, y] = places[0];
    let moves = places.iter().map(|[x, y]| format!("M2,{x:.4},{y:.4}\n")).collect::<String>();
    let text = format!(
        "MS,2,1\nJZ,.2\nJ2,{x:.4},{y:.4}\nSO,1,1\nPAUSE .2\nMZ,-.1\n{moves}JZ,.2\nSO,1,0\n"
    );
    (text, places)
}

/// Everything was cut, and nothing beside the path.
fn is_whole(bench: &Bench, places: &[[f64; 2]]) {
    let deep = bench.look(|fake| fake.cut.clone());
    let deep: Vec<_> = deep.iter().map(|place| place.0).filter(|[_, _, z, ..]| *z < -2.5).collect();
    let far = |x: f64, y: f64| {
        deep.iter().map(|it| (it[0] - x).hypot(it[1] - y)).fold(f64::INFINITY, f64::min)
    };
    for pair in places.windows(2) {
        let [[ax, ay], [bx, by]] = [pair[0], pair[1]];
        for n in 0..4 {
            let at = f64::from(n) / 4.0;
            let (x, y) = (25.4 * (ax + (bx - ax) * at), 25.4 * (ay + (by - ay) * at));
            assert!(far(x, y) < 0.06, "nothing was cut at {x:.3}, {y:.3}: {:.3}", far(x, y));
        }
    }
    for it in &deep {
        let near = places.windows(2).any(|pair| beside(pair, it[0] / 25.4, it[1] / 25.4) < 0.002);
        assert!(near, "cut beside the path at {it:?}");
    }
}

/// The distance of a place from a straight way.
fn beside(way: &[[f64; 2]], x: f64, y: f64) -> f64 {
    let [[ax, ay], [bx, by]] = [way[0], way[1]];
    let (dx, dy) = (bx - ax, by - ay);
    let along = (((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
    (x - ax - dx * along).hypot(y - ay - dy * along)
}

fn resumes(bench: &Bench, shop: &Shop, words: &str) -> Did {
    shop.kerf(&format!("run --resume --machine grbl:{} {words}", bench.port))
}

#[test]
fn a_run_that_was_killed_is_taken_up_on_its_controller() {
    let (text, places) = spiral();
    for millis in [900, 2100, 3300] {
        let (shop, bench) = (Shop::new(&[("spiral.sbp", &text)]), Bench::new(&[]));
        shop.write("yes.txt", b"hold=Resume\nlocation=Continue\n");
        let mut child = bench.start(&shop, "run spiral.sbp");
        bench.until(|fake| fake.position().0[2] < -2.5);
        sleep(Duration::from_millis(millis));
        child.kill().unwrap();
        child.wait().unwrap();
        // It makes what it has in its buffer, and its spindle turns on.
        sleep(Duration::from_millis(700));
        let other = format!("it ran on grbl:{}", bench.port);
        shop.kerf("run --resume").exits(1).complains(&other);
        let again = resumes(&bench, &shop, "--answers yes.txt");
        again.exits(0).says("ran to its end");
        is_whole(&bench, &places);
        assert_eq!(bench.look(|fake| fake.spindle()), None);
    }
}

/// A controller without homing that lost its power counts from zero: its place is not known.
#[test]
fn a_run_is_not_taken_up_where_nobody_knows_the_place() {
    let (text, _) = spiral();
    let (shop, bench) = (Shop::new(&[("spiral.sbp", &text)]), Bench::new(&[]));
    let mut child = bench.start(&shop, "run spiral.sbp");
    bench.until(|fake| fake.position().0[2] < -2.5);
    child.kill().unwrap();
    child.wait().unwrap();
    bench.look(kerf_driver_grbl::fake::Fake::begins_anew);
    let way_mm = bench.look(|fake| fake.way_mm());
    let again = resumes(&bench, &shop, "");
    again.exits(1).complains("has not kept count of where it stands");
    assert_eq!(bench.look(|fake| fake.way_mm()), way_mm, "nothing moves");
}
