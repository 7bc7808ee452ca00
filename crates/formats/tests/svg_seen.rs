//! Visible parts of an SVG, their place and size: styles, percentages, hidden elements.

use kerf_formats::{Imported, svg};

/// An SVG of 100 × 50 mm, a unit a millimetre.
fn read(body: &str) -> Imported {
    let text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"50mm\" \
         viewBox=\"0 0 100 50\">{body}</svg>"
    );
    svg::read(text.as_bytes())
}

/// Bounds of every shape, from the upper left of the page, as `x,y width x height`.
fn boxes(read: &Imported) -> Vec<String> {
    let round = |value: f64| (value * 1e3).round() / 1e3 + 0.0;
    let shown = |shape: &kerf_drawing::Shape| {
        let bounds = shape.path.bounds();
        let [x, y] = [bounds.min.x, 50.0 - bounds.max.y].map(round);
        let [w, h] = [bounds.size().x, bounds.size().y].map(round);
        format!("{x},{y} {w}x{h}")
    };
    read.drawing.shapes.iter().map(|shape| shown(shape)).collect()
}

fn told(read: &Imported) -> Vec<&str> {
    read.findings.iter().map(|finding| finding.text.as_str()).collect()
}

/// Checks where the shapes of a body lie, and that nothing is told of it.
#[track_caller]
fn check(body: &str, expected: &[&str]) {
    let read = read(body);
    assert_eq!(boxes(&read), expected, "{body}");
    assert_eq!(told(&read), [""; 0], "{body}");
}

/// Checks what is told of a body, and that none of it is drawn.
#[track_caller]
fn check_hidden(body: &str, why: &str) {
    let read = read(body);
    assert_eq!(boxes(&read), [""; 0], "{body}");
    assert!(told(&read)[0].contains(why), "{body}: {:?}", told(&read));
}

#[test]
fn percentages_are_parts_of_the_page() {
    check("<rect x='10%' y='10%' width='50%' height='50%'/>", &["10,5 50x25"]);
    check("<circle cx='50%' cy='50%' r='10'/>", &["40,15 20x20"]);
    check("<line x1='0%' y1='0%' x2='100%' y2='100%'/>", &["0,0 100x50"]);
    check("<ellipse cx='50' cy='25' rx='10%' ry='10%'/>", &["40,20 20x10"]);
    // The diagonal of 100 by 50 divided by the root of two is 79.057.
    check("<circle cx='50' cy='25' r='10%'/>", &["42.094,17.094 15.811x15.811"]);
    check(
        "<g id='a'/><use href='#b' x='10%' y='10%'/><defs><rect id='b' width='1' height='1'/></defs>",
        &["10,5 1x1"],
    );
}

#[test]
fn percentages_are_parts_of_what_they_stand_in() {
    let inner = "<rect width='50%' height='50%'/>";
    check(&format!("<svg x='10' y='10' width='20' height='30'>{inner}</svg>"), &["10,10 10x15"]);
    let view = "viewBox='0 0 10 10'";
    check(&format!("<svg width='20' height='20' {view}>{inner}</svg>"), &["0,0 10x10"]);
    // Without a size it fills the page, in its middle.
    check(&format!("<svg {view}>{inner}</svg>"), &["25,0 25x25"]);
    check(&format!("<svg width='50%' height='100%' {view}>{inner}</svg>"), &["0,0 25x25"]);
    let symbol = format!("<symbol id='s' {view}>{inner}</symbol>");
    check(&format!("{symbol}<use href='#s' width='20' height='20'/>"), &["0,0 10x10"]);
}

#[test]
fn lengths_follow_the_size_of_letters() {
    check("<rect width='2em' height='1rem' font-size='5'/>", &["0,0 10x16"]);
    check("<g style='font-size: 5px'><rect width='2em' height='2ex'/></g>", &["0,0 10x5"]);
    check(
        "<g font-size='10'><g font-size='50%'><rect width='2em' height='1em'/></g></g>",
        &["0,0 10x5"],
    );
    check(
        "<g style='font: bold 5px/7px Arial'><rect width='2em' height='1em'/></g>",
        &["0,0 10x5"],
    );
}

#[test]
fn a_length_that_cannot_be_read_leaves_its_element_out() {
    check_hidden(
        "<rect x='calc(1px + 1%)' width='5' height='5'/>",
        "<rect> x: `calc(1px + 1%)` is no length that Kerf reads: left out",
    );
    check_hidden("<rect x='3 furlongs' width='5' height='5'/>", "is no length");
    check_hidden(
        "<defs><rect id='r' width='1' height='1'/></defs><use href='#r' x='wide'/>",
        "is no length",
    );
    let text = "<svg xmlns='http://www.w3.org/2000/svg'><circle r='5' cx='50%'/></svg>";
    let read = svg::read(text.as_bytes());
    assert_eq!(told(&read), ["<circle> cx: `50%` of a page whose size is not told: left out"]);
}

#[test]
fn what_is_hidden_is_left_out_and_told() {
    let rect = "<rect width='5' height='5'/>";
    for (how, why) in [
        ("display='none'", "display: none"),
        ("style='DISPLAY : none !important'", "display: none"),
        ("opacity='0'", "opacity: 0"),
        ("style='opacity:0.0'", "opacity: 0"),
        ("style='opacity: 0%'", "opacity: 0"),
        ("visibility='hidden'", "visibility: hidden"),
        ("style='visibility:hidden'", "visibility: hidden"),
        ("visibility='collapse'", "visibility: hidden"),
    ] {
        check_hidden(&format!("<g {how}>{rect}</g>"), why);
        check_hidden(&format!("<g><rect width='5' height='5' {how}/></g>"), why);
    }
    check(&format!("<g opacity='0.5' display='inline'>{rect}</g>"), &["0,0 5x5"]);
}

#[test]
fn what_is_visible_within_the_hidden_is_drawn() {
    let body = "<g visibility='hidden'><rect width='5' height='5' visibility='visible'/><line x2='9'/></g>";
    assert_eq!(boxes(&read(body)), ["0,0 5x5"]);
}

#[test]
fn style_sheets_say_what_is_seen() {
    let sheet =
        |rules: &str, body: &str| boxes(&read(&format!("<style>{rules}</style>{body}"))).len();
    let body = "<g class='a b' id='g'><rect width='5' height='5' class='c'/><line x2='9'/></g>";
    assert_eq!(sheet(".guide { display: none }", body), 2);
    assert_eq!(sheet(".b { display: none }", body), 0);
    assert_eq!(sheet("#g { display: none }", body), 0);
    assert_eq!(sheet("line { display: none }", body), 1);
    assert_eq!(sheet("* { display: none }", body), 0);
    assert_eq!(sheet("circle, rect { display: none }", body), 1);
    assert_eq!(sheet(".a .c { display: none }", body), 1);
    assert_eq!(sheet(".a > line { display: none }", body), 1);
    assert_eq!(sheet(".c .a { display: none }", body), 2);
    assert_eq!(sheet("<![CDATA[ .c { display: none } ]]>", body), 1);
    assert_eq!(sheet("/* .c { */ line /* } */ { fill: red; /* a:b; */ display: none }", body), 1);
}

#[test]
fn the_stronger_rule_holds() {
    let drawn = |rules: &str, own: &str| {
        let rect = format!("<rect id='r' class='c' width='5' height='5' {own}/>");
        !boxes(&read(&format!("<style>{rules}</style>{rect}"))).is_empty()
    };
    assert!(drawn("#r { display: inline } .c { display: none }", ""));
    assert!(drawn(".c { display: inline } rect { display: none }", ""));
    assert!(!drawn(".c { display: inline } .c { display: none }", ""));
    assert!(drawn(".c { display: inline }", "display='none'"));
    assert!(drawn("#r { display: none }", "style='display: inline'"));
    assert!(!drawn("rect { display: none !important }", "style='display: inline'"));
}

#[test]
fn style_sheets_say_how_large_and_where() {
    check(
        "<style>rect{width:50%;height:5px;x:1px}</style><rect width='1' height='1'/>",
        &["1,0 50x5"],
    );
    check(
        "<style>.m{transform:translate(10px,20px)}</style><rect class='m' width='1' height='1'/>",
        &["10,20 1x1"],
    );
    check("<path style='d: path(\"M0 0H5V5\")' d='M9 9'/>", &["0,0 5x5"]);
}

#[test]
fn transforms_of_styles_are_done() {
    let moved = |style: &str| {
        boxes(&read(&format!("<rect width='10' height='5' style='{style}'/>"))).join("")
    };
    assert_eq!(moved("transform: translate(10%, 10%)"), "10,5 10x5");
    assert_eq!(moved("transform:translateX(1mm) translateY(2px)"), "3.78,2 10x5");
    assert_eq!(moved("transform: scale(2)"), "0,0 20x10");
    assert_eq!(moved("transform: scale(2, 3) translate(1px, 1px)"), "2,3 20x15");
    assert_eq!(moved("transform: translate(5px) rotate(0.25turn)"), "0,0 5x10");
    assert_eq!(moved("transform: rotate(100grad) translate(0, -5px)"), "0,0 5x10");
    assert_eq!(moved("transform: matrix(1, 0, 0, 1, 7, 8)"), "7,8 10x5");
    assert_eq!(moved("transform: skewX(45deg)"), "0,0 15x5");
    assert_eq!(moved("transform: rotate(180deg); transform-origin: 10px 5px"), "10,5 10x5");
    assert_eq!(moved("transform: rotate(180deg); transform-origin: center"), "90,45 10x5");
    assert_eq!(moved("transform: none"), "0,0 10x5");
    check(
        "<rect width='10' height='5' transform='translate(9)' style='transform: scale(2)'/>",
        &["0,0 20x10"],
    );
}

#[test]
fn a_transform_that_cannot_be_read_leaves_its_element_out() {
    let rect = |how: &str| format!("<rect width='5' height='5' {how}/>");
    check_hidden(
        &rect("style='transform: rotate3d(1, 1, 1, 45deg)'"),
        "rotate3d(1, 1, 1, 45deg)` is not read: <rect> is left out",
    );
    check_hidden(&rect("style='rotate: 45deg'"), "`rotate` is not read");
    check_hidden(&rect("transform='tilt(5)'"), "transform: ");
    let own_box =
        "style='transform: rotate(45deg); transform-box: fill-box; transform-origin: center'";
    check_hidden(&rect(own_box), "own box");
}

#[test]
fn one_way_of_a_switch_is_drawn() {
    let (a, b) = ("<rect width='5' height='5'/>", "<rect width='9' height='9'/>");
    let foreign = "<foreignObject requiredExtensions='http://ns.adobe.com/'/>";
    check(&format!("<switch>{foreign}<g>{a}</g></switch>"), &["0,0 5x5"]);
    let two = read(&format!("<switch>\n<g systemLanguage='de'>{a}</g>\n<g>{b}</g>{a}</switch>"));
    assert_eq!(boxes(&two), ["0,0 9x9"]);
    assert_eq!(told(&two), ["<switch>: drawn is what line 3 has; other ways left out: 2"]);
}

#[test]
fn what_is_not_drawn_is_told_with_line_and_column() {
    let place = |body: &str| {
        let read = read(body);
        let found = &read.findings[0];
        (found.line, found.column, found.text.clone())
    };
    let (line, column, text) = place("\n  <text>a</text>");
    assert_eq!((line, column), (2, 3));
    assert!(text.starts_with("<text> is left out"));
    for (body, why) in [
        ("<image href='a.png'/>", "<image> is left out"),
        ("<foreignObject/>", "<foreignObject> is left out"),
        ("<g clip-path='url(#c)'><line x2='9'/></g>", "clip-path is not applied"),
        ("<line x2='9' style='mask: url(#m)'/>", "mask is not applied"),
        ("<line x2='9' marker-end='url(#m)'/>", "markers (arrow heads) are left out"),
        ("<pattern id='p'/><rect width='5' height='5' fill='url(#p)'/>", "the pattern of the fill"),
        ("<line x2='9' stroke-dasharray='3 1'/>", "a dashed line is drawn whole"),
        ("<rect width='5' height='5' fill='none'/>", "neither fill nor stroke"),
        ("<style>@media print { a { b: c } }</style>", "the rules of `@media` are not read"),
        ("<style>rect:nth-child(2) { b: c }</style>", "selector `rect:nth-child(2)` is not read"),
        ("<style>rect { b: c</style>", "without its end"),
        ("<style type='text/less'>rect {}</style>", "`text/less` is not read"),
    ] {
        let (line, column, text) = place(&format!("\n{body}"));
        assert!(line == 2 && column > 0 && text.contains(why), "{body}: {line}:{column} {text}");
    }
}

#[test]
fn files_in_other_letters_are_read() {
    let text = "<svg xmlns='http://www.w3.org/2000/svg'><rect width='9' height='9'/></svg>";
    let little: Vec<u8> =
        "\u{feff}".chars().chain(text.chars()).flat_map(|c| (c as u16).to_le_bytes()).collect();
    let big: Vec<u8> = little.chunks(2).flat_map(|two| [two[1], two[0]]).collect();
    for bytes in [text.as_bytes(), &little, &big] {
        assert_eq!(svg::read(bytes).drawing.shapes.len(), 1);
    }
    assert!(told(&svg::read(&[0x1f, 0x8b, 8, 0])).concat().contains("is compressed (.svgz)"));
}
