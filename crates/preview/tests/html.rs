//! The page: whole without a network, and everything in it that the viewer reads.

use crate::common;
use kerf_preview::{Options, Scene, ToolPath, html};

fn page(scene: &Scene) -> String {
    html(scene, &Options::default())
}

fn element<'a>(page: &'a str, id: &str) -> &'a str {
    let start = page.find(&format!("id=\"{id}\">")).unwrap();
    let text = &page[start + id.len() + 6..];
    &text[..text.find("</script>").unwrap()]
}

fn facts(page: &str) -> serde_json::Value {
    serde_json::from_str(element(page, "facts")).unwrap()
}

#[test]
fn nothing_is_fetched() {
    let page = page(&common::plate());
    for reference in
        ["http://", "https://", "src=", "@import", "url(", "fetch(", "XMLHttp", "import("]
    {
        assert!(!page.contains(reference), "{reference}");
    }
    assert!(page.contains("default-src 'none'"));
    assert!(page.contains("<html lang=\"en\">") && page.contains("<title>Test</title>"));
    assert!(!page.contains("{{"), "a part is missing");
}

#[test]
fn titles_cannot_end_a_script() {
    let mut scene = common::plate();
    scene.title = "</script><script>alert(1)</script> {{facts}}".into();
    scene.toolpaths.push(ToolPath {
        name: "</script><b>".into(),
        tool: String::new(),
        seconds: 1.0,
        first_segment: 2,
    });
    let page = page(&scene);
    assert_eq!(page.matches("</script>").count(), 3, "facts, motion and the viewer");
    let facts = facts(&page);
    assert_eq!(facts["title"], scene.title.as_str());
    assert_eq!(facts["toolpaths"][0]["name"], "</script><b>");
    assert_eq!(facts["toolpaths"][0]["piece"], 2);
    assert!(page.contains("alert(1)&lt;/script&gt; {{facts}}"));
}

/// The length that the viewer expects for what the facts say.
fn expected_bytes(facts: &serde_json::Value) -> usize {
    let pieces = facts["pieces"].as_u64().unwrap() as usize;
    let points = if pieces == 0 { 0 } else { 12 * (pieces + 1) };
    let chains = if facts["rolled"].is_null() { 1 } else { 2 };
    chains * points + 4 * pieces + if facts["times"] == true { 4 * pieces } else { 0 } + pieces
}

#[test]
fn the_motion_is_as_long_as_the_facts_say() {
    let mut timed = common::plate();
    timed.times_s = (1..=timed.segments.len()).map(|i| i as f32).collect();
    let mut short = timed.clone();
    short.times_s.pop();
    let mut rotary = common::plate();
    rotary.turns_deg = vec![[0.0, 90.0]; rotary.segments.len()];
    assert!(facts(&page(&rotary))["rolled"].is_array());
    assert!(facts(&page(&rotary))["axis"].is_f64());
    for (scene, times) in [
        (common::plate(), false),
        (rotary, false),
        (timed, true),
        (short, false),
        (Scene::default(), false),
    ] {
        let page = page(&scene);
        let facts = facts(&page);
        assert_eq!(facts["times"], times);
        let text = element(&page, "motion");
        let padding = text.bytes().rev().take_while(|b| *b == b'=').count();
        assert_eq!(text.len() / 4 * 3 - padding, expected_bytes(&facts));
    }
}

#[test]
fn odd_numbers_and_empty_scenes_give_a_page() {
    for scene in [Scene::default(), common::odd()] {
        let facts = facts(&page(&scene));
        let numbers =
            ["middle", "low", "high", "depth"].iter().flat_map(|n| facts[*n].as_array().unwrap());
        assert!(numbers.into_iter().all(serde_json::Value::is_number), "{facts}");
        assert!(
            facts["surface"].is_number() && facts["cutter"].is_number() && facts["table"].is_null()
        );
    }
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    assert_eq!(page(&common::plate()), page(&common::plate()));
}
