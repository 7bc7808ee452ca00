//! Scenes that try the drawing: plain work, dense work, and what may not break it.

use kerf_diag::Severity;
use kerf_geom::{Arc2, Bounds3, Point2};
use kerf_preview::{Finding, Scene, Segment, Shape, TableView, ToolPath, Unit};
use kerf_program::MoveKind;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Makes a scene.
pub type Make = fn() -> Scene;

/// All of them by name.
pub const ALL: [(&str, Make); 13] = [
    ("rectangle", rectangle),
    ("spiral", spiral),
    ("pocket", pocket),
    ("relief", relief),
    ("tall", tall),
    ("wide", wide),
    ("drill", drill),
    ("empty", empty),
    ("huge", huge),
    ("tiny", tiny),
    ("odd", odd),
    ("million", million),
    ("noise", noise),
];

/// Speeds of the gallery's machine, mm/s.
const CUT_MM_S: f64 = 50.0;
const JOG_MM_S: f64 = 150.0;

/// Moves a tool and remembers how.
struct Tool {
    scene: Scene,
    at: [f64; 3],
    line: u32,
    time_s: f64,
}

impl Tool {
    fn new(title: &str, unit: Unit) -> Self {
        let scene = Scene { title: title.into(), unit, ..Scene::default() };
        Self { scene, at: [0.0, 0.0, 20.0], line: 0, time_s: 0.0 }
    }

    fn go(&mut self, kind: MoveKind, to: [f64; 3], shape: Shape) {
        self.line += 1;
        let d: [f64; 3] = std::array::from_fn(|i| to[i] - self.at[i]);
        let flat = match shape {
            Shape::Line => d[0].hypot(d[1]),
            Shape::Arc { centre: [x, y], sweep_rad } => {
                sweep_rad.abs() * (self.at[0] - x).hypot(self.at[1] - y)
            }
        };
        let length = flat.hypot(d[2]);
        let cut = kind == MoveKind::Cut;
        *(if cut { &mut self.scene.cut_mm } else { &mut self.scene.jog_mm }) += length;
        self.time_s += length / if cut { CUT_MM_S } else { JOG_MM_S };
        if cut {
            self.scene.bounds.add(self.at);
            self.scene.bounds.add(to);
            if let Shape::Arc { centre: [x, y], sweep_rad } = shape {
                let (start, z) = (Point2::new(self.at[0], self.at[1]), to[2]);
                let arc = Arc2 { start, centre: Point2::new(x, y), sweep_rad };
                arc.extremes(|p| self.scene.bounds.add([p.x, p.y, z]));
            }
        }
        self.scene.segments.push(Segment { kind, from: self.at, to, shape, line: self.line });
        self.scene.times_s.push(self.time_s as f32);
        self.at = to;
    }

    fn cut(&mut self, x: f64, y: f64, z: f64) {
        self.go(MoveKind::Cut, [x, y, z], Shape::Line);
    }

    fn jog(&mut self, x: f64, y: f64) {
        let safe = 20.0;
        let [x0, y0, _] = self.at;
        self.go(MoveKind::Jog, [x0, y0, safe], Shape::Line);
        self.go(MoveKind::Jog, [x, y, safe], Shape::Line);
    }

    fn plunge(&mut self, z: f64) {
        let [x, y, _] = self.at;
        self.cut(x, y, z);
    }

    fn arc(&mut self, centre: [f64; 2], sweep_rad: f64, z: f64) {
        let start = Point2::new(self.at[0], self.at[1]);
        let end = Arc2 { start, centre: Point2::new(centre[0], centre[1]), sweep_rad }.end();
        self.go(MoveKind::Cut, [end.x, end.y, z], Shape::Arc { centre, sweep_rad });
    }

    fn toolpath(&mut self, name: &str, tool: &str) {
        let toolpath = ToolPath {
            name: name.into(),
            tool: tool.into(),
            seconds: 0.0,
            first_segment: self.scene.segments.len(),
        };
        self.scene.toolpaths.push(toolpath);
    }

    fn done(mut self) -> Scene {
        self.scene.duration_s = self.time_s;
        self.scene.lines_executed = u64::from(self.line);
        let starts: Vec<usize> =
            self.scene.toolpaths.iter().skip(1).map(|t| t.first_segment).collect();
        let time = |i: usize| self.scene.times_s.get(i).map_or(0.0, |t| f64::from(*t));
        let mut before = 0.0;
        let ends: Vec<f64> = starts.iter().map(|s| time(s - 1)).chain([self.time_s]).collect();
        for (toolpath, end) in self.scene.toolpaths.iter_mut().zip(ends) {
            toolpath.seconds = end - before;
            before = end;
        }
        self.scene
    }
}

fn table(x: f64, y: f64, w: f64, h: f64, grid: f64) -> Option<TableView> {
    Some(TableView { origin: [x, y], size_mm: [w, h, 150.0], grid_mm: grid })
}

fn rounded(tool: &mut Tool, [x0, y0, x1, y1]: [f64; 4], r: f64, z: f64) {
    tool.cut(x1 - r, y0, z);
    tool.arc([x1 - r, y0 + r], FRAC_PI_2, z);
    tool.cut(x1, y1 - r, z);
    tool.arc([x1 - r, y1 - r], FRAC_PI_2, z);
    tool.cut(x0 + r, y1, z);
    tool.arc([x0 + r, y1 - r], FRAC_PI_2, z);
    tool.cut(x0, y0 + r, z);
    tool.arc([x0 + r, y0 + r], FRAC_PI_2, z);
}

/// A rounded plate with a slot, a bore and depth passes.
fn rectangle() -> Scene {
    let mut t = Tool::new("Hinge plate <rev. B>", Unit::MM);
    t.scene.table = table(-20.0, -20.0, 400.0, 300.0, 50.0);
    t.scene.cutter_mm = 6.0;
    t.toolpath("Slot", "6 mm end mill");
    t.jog(60.0, 100.0);
    t.plunge(0.0);
    t.cut(180.0, 100.0, -3.0);
    t.cut(60.0, 100.0, -3.0);
    t.toolpath("Bores", "6 mm end mill");
    for (x, y) in [(50.0, 50.0), (190.0, 50.0), (190.0, 140.0), (50.0, 140.0)] {
        t.jog(x + 6.0, y);
        t.plunge(0.0);
        for pass in 1..=4 {
            t.arc([x, y], TAU, -3.0 * f64::from(pass));
        }
        t.arc([x, y], TAU, -12.0);
    }
    t.toolpath("Outer contour", "6 mm end mill");
    t.jog(40.0, 20.0);
    for pass in 1..=4 {
        let z = -3.0 * f64::from(pass);
        t.plunge(z);
        rounded(&mut t, [20.0, 20.0, 220.0, 170.0], 20.0, z);
    }
    t.jog(0.0, 0.0);
    t.scene.findings.push(Finding {
        severity: Severity::Warning,
        text: "plunge at jog speed above the surface".into(),
        line: 12,
    });
    t.done()
}

fn spiral() -> Scene {
    let mut t = Tool::new("Spiral bowl", Unit::INCH);
    t.scene.table = table(0.0, 0.0, 2438.4, 1219.2, 152.4);
    t.scene.cutter_mm = 3.175;
    t.jog(150.0, 150.0);
    t.plunge(-24.0);
    let centre = [150.0, 150.0];
    for i in 0..80 {
        let r = 1.5 * f64::from(i + 1) / 2.0;
        let side = if i % 2 == 0 { 1.0 } else { -1.0 };
        let (x, y) = (t.at[0], t.at[1]);
        t.arc([x - side * r + side * 0.375, y], PI, -24.0 * (1.0 - (r / 62.0).powi(2)).max(0.0));
        let _ = (centre, y);
    }
    t.jog(0.0, 0.0);
    t.done()
}

fn pocket() -> Scene {
    let mut t = Tool::new("Circle pocket with helical entry", Unit::MM);
    t.scene.cutter_mm = 8.0;
    t.jog(50.0, 40.0);
    for level in 1..=3 {
        let z = -4.0 * f64::from(level);
        t.jog(53.0, 40.0);
        t.plunge(z + 4.0);
        t.arc([50.0, 40.0], -2.0 * TAU, z);
        for ring in 0..5 {
            let r = 3.0 + 6.0 * f64::from(ring);
            t.cut(50.0 + r, 40.0, z);
            t.arc([50.0, 40.0], -TAU, z);
        }
    }
    t.jog(0.0, 0.0);
    t.done()
}

fn height(x: f64, y: f64) -> f64 {
    let r = (x * x + y * y).sqrt();
    -6.0 + 5.0 * (0.18 * r).cos() * (-r / 60.0).exp() + 0.8 * (0.5 * x).sin()
}

fn raster(t: &mut Tool, size: f64, rows: u32, columns: u32) {
    t.jog(0.0, 0.0);
    for row in 0..rows {
        let y = size * f64::from(row) / f64::from(rows - 1);
        for column in 0..columns {
            let share = f64::from(column) / f64::from(columns - 1);
            let x = size * if row % 2 == 0 { share } else { 1.0 - share };
            t.cut(x, y, height(x - 0.5 * size, y - 0.5 * size).min(0.0));
        }
    }
    t.jog(0.0, 0.0);
}

fn relief() -> Scene {
    let mut t = Tool::new("Relief, 3D raster", Unit::MM);
    t.scene.table = table(-50.0, -50.0, 300.0, 300.0, 100.0);
    t.scene.cutter_mm = 3.0;
    t.toolpath("Finish", "3 mm ball nose");
    raster(&mut t, 120.0, 61, 121);
    t.done()
}

fn tall() -> Scene {
    let mut t = Tool::new("Ruler stick", Unit::INCH);
    t.scene.cutter_mm = 1.0;
    for i in 0..=48 {
        let y = 25.4 * f64::from(i);
        t.jog(0.0, y);
        t.plunge(-0.5);
        t.cut(if i % 12 == 0 { 30.0 } else { 15.0 }, y, -0.5);
    }
    t.jog(0.0, 0.0);
    t.done()
}

fn wide() -> Scene {
    let mut t = Tool::new(
        "Workspace edge with a name that is far too long for one line of a heading on this sheet of paper, whatever its size",
        Unit::MM,
    );
    t.scene.table = table(0.0, 0.0, 2440.0, 400.0, 100.0);
    t.scene.cutter_mm = 12.0;
    for (i, name) in
        ["Roughing", "Finishing", "Chamfer", "Drilling", "Cut-out"].into_iter().enumerate()
    {
        t.toolpath(name, &format!("Tool {}", i + 1));
        let y = 60.0 + 50.0 * i as f64;
        t.jog(100.0, y);
        t.plunge(-2.0 * (i + 1) as f64);
        for k in 0..10 {
            let x = 100.0 + 220.0 * f64::from(k);
            t.arc([x + 55.0, y], -PI, -2.0 * (i + 1) as f64);
            t.arc([x + 165.0, y], PI, -2.0 * (i + 1) as f64);
        }
    }
    t.jog(0.0, 0.0);
    t.done()
}

fn drill() -> Scene {
    let mut t = Tool::new("Peg board", Unit::INCH);
    t.scene.table = table(0.0, 0.0, 609.6, 457.2, 25.4);
    t.scene.cutter_mm = 6.35;
    for row in 0..12 {
        for column in 0..18 {
            let column = if row % 2 == 0 { column } else { 17 - column };
            t.jog(25.4 * f64::from(column + 2), 25.4 * f64::from(row + 2));
            t.plunge(-3.0 - f64::from(row));
            let [x, y, _] = t.at;
            t.cut(x, y, 20.0);
        }
    }
    t.jog(0.0, 0.0);
    t.done()
}

fn empty() -> Scene {
    let mut scene = Scene { title: "Nothing yet".into(), unit: Unit::INCH, ..Scene::default() };
    scene.table = table(0.0, 0.0, 2438.4, 1219.2, 152.4);
    scene
}

fn shifted(mut scene: Scene, by: f64, scale: f64) -> Scene {
    let place = |p: [f64; 3]| [p[0] * scale + by, p[1] * scale + by, p[2] * scale];
    scene.bounds = Bounds3 { min: place(scene.bounds.min), max: place(scene.bounds.max) };
    scene.cutter_mm *= scale;
    scene.cut_mm *= scale;
    scene.jog_mm *= scale;
    scene.table = None;
    for s in &mut scene.segments {
        (s.from, s.to) = (place(s.from), place(s.to));
        if let Shape::Arc { centre, .. } = &mut s.shape {
            *centre = centre.map(|v| v * scale + by);
        }
    }
    scene
}

fn huge() -> Scene {
    Scene { title: "Far away".into(), ..shifted(rectangle(), 3.0e6, 1.0) }
}

fn tiny() -> Scene {
    Scene { title: "A tenth of a millimetre".into(), ..shifted(rectangle(), 0.0, 0.0005) }
}

fn odd() -> Scene {
    let mut scene = rectangle();
    scene.title = "Odd numbers".into();
    for (i, bad) in [f64::NAN, f64::INFINITY, 1e300, -f64::INFINITY].into_iter().enumerate() {
        scene.segments[7 * i + 3].to[i % 3] = bad;
    }
    scene.cut_mm = f64::NAN;
    scene.duration_s = f64::INFINITY;
    scene
}

fn million() -> Scene {
    let mut t = Tool::new("A million moves", Unit::MM);
    t.scene.cutter_mm = 1.0;
    raster(&mut t, 500.0, 1000, 1000);
    t.done()
}

/// A million moves with nothing to simplify: the worst there can be.
fn noise() -> Scene {
    let mut t = Tool::new("Noise", Unit::MM);
    let mut seed = 1u32;
    let mut next = move || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 8) / f64::from(1 << 24)
    };
    for i in 0..1_000_000 {
        let (x, y) = (f64::from(i % 1000), f64::from(i / 1000));
        t.cut(0.3 * x + 2.0 * next(), 0.3 * y + 2.0 * next(), -5.0 * next());
    }
    t.done()
}
