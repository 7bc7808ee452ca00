//! The fastest motion along a path within the limits of every axis and a tolerance of the path.
//!
//! A [`Solver`] is given moves as [`Leg`]s, one after the other, and gives back pieces of motion, each a [`Timed`]: a
//! smoothed path, and a list of [`Node`]s between which the motion along it has a closed form. It knows no settings,
//! no stops and no other model; those are in `kerf-motion`.
//!
//! ```text
//!  Leg ─► track ─► widths ─► choice ─► walk ─► gate, passes ──────────────────────┐
//!                    │                                                             ├─► nodes ─► Timed
//!                    └─────► cells ─► horizon ─► window ─► pieces, problem, jerk ──┘
//!                                     with a limit of jerk
//! ```
//!
//! # Formulas
//!
//! **Path.** The moves become a polyline over one length s in all axes, mm (`track`); a degree counts as a
//! millimetre. At a vertex where the unit tangent turns by the vector D a bump D·h(s) is added, of half-width c
//! (`kernel`, `widths`). For motion limited in acceleration the second derivative of a bump is a box:
//!
//! ```text
//!  h(d) = (c − |d|)²/4c,   q″ = D/2c constant within |d| < c,   height h(0) = c/4 ≤ tolerance
//! ```
//!
//! With a limit of jerk it is a triangle, or for sharp corners a sum of triangles. Bumps may overlap; their sum is
//! kept within the tolerance at each vertex. Of two ways to choose the widths `choice` takes the faster one.
//!
//! **Motion.** With q(s) the path and y = ṡ² the squared speed along it,
//!
//! ```text
//!  velocity      q′·ṡ
//!  acceleration  q′·s̈ + q″·ṡ²           s̈ = y′/2
//!  jerk          q′·s⃛ + 3·q″·ṡ·s̈ + q‴·ṡ³
//!  feed          y ≤ F²/Σ q′ₖ²           over the axes k along which the feed F is meant
//! ```
//!
//! **Without a limit of jerk** (`gate`, `passes`). On a cell between two places where a bump begins or ends q″ is
//! constant, and with y linear in s each limit is linear in its values y₀, y₁ at both ends,
//!
//! ```text
//!  |α·y₀ + β·y₁| ≤ a,   α = q″ − q′/2h, β = q′/2h at the start; α = −q′/2h, β = q″ + q′/2h at the end
//! ```
//!
//! so from one y₁ an interval of y₀ can be reached (Pham & Pham 2018, reachability). A pass back keeps the greatest y
//! that can still be slowed from, a pass forward takes the fastest way below it.
//!
//! **With a limit of jerk** (`horizon` and below). x(s) = ṡ² is a quadratic spline over the pieces of a window, with
//! the middle Bézier ordinate bₖ of each piece as its unknown. Per axis and piece the acceleration f = q′·x′/2 + q″·x
//! is a cubic with ordinates linear in x (`pieces`), and the jerk is f′·√x. Sought is
//!
//! ```text
//!  minimise  T(b) = Σ ∫ ds/√x
//!  where     0 < x ≤ cap,   |f| ≤ a,   |f′| ≤ J/√x     for every ordinate
//! ```
//!
//! J/√x is convex in x; it is replaced by its tangent at the present mean of x, which lies below it, so the linear
//! condition is safe (`barriers`; after Zhang et al. 2014 and Lee et al. 2024). The interior-point method
//! (`jerk`) minimises w·T + Σ −ln(slack) for a growing weight w with Newton's steps; `newton` has the gradient and
//! the matrix of five diagonals, `condition` the slacks. It ends when the barriers cost no more than a share of the
//! time: w·T·gap ≥ number of conditions.
//!
//! From rest x grows as s^(4/3), which no parabola does. So the first and the last bit of path w is made with
//! constant jerk j instead (`launch`): s = j·t³/6, x = (4.5·j·w²)^(2/3).
//!
//! **Time.** Between nodes s̈ is constant, or linear in time (constant jerk), or linear in s: then s̈ = a + r·(s − s₀)
//! has the solution s − s₀ = v·sinh(ωt)/ω + a·(cosh ωt − 1)/r with ω² = r, sin and cos for r < 0 (`node`).
//!
//! # States of a run with a limit of jerk
//!
//! ```text
//!               begin in motion (another feed)
//!                            │
//!                            ▼
//!                Motion(ways, no stand known) ─── no way found: lost ─► Rest
//!                            │ solved
//!                            ▼
//!   Rest ── solved ─► Motion(ways, stand known) ─┬─ the run ends, solved: land ─► Rest
//!    ▲         more is final ▲ │                 ├─ no way found: run on to the stand ─► Rest
//!    │                       └─┘ solved          └─ settled early: the same ─► Rest
//!    └── one straight line: seven phases of constant jerk, at rest again
//! ```
//!
//! A window that is too short for braking waits for more cells. `ways` are always within the limits, so there is a
//! way out of each state: the search only betters it.

mod axes;
mod barriers;
mod begin;
mod bounds;
mod cells;
mod choice;
mod condition;
mod cut;
mod found;
mod gate;
mod horizon;
mod jerk;
mod kernel;
mod launch;
mod leg;
mod newton;
mod node;
mod passes;
mod pieces;
mod problem;
mod scurve;
mod solver;
mod speed_piece;
mod timed;
mod track;
mod variants;
mod walk;
mod widths;
mod window;

pub use leg::{Basis, Leg, Shape};
pub use node::{Along, Node, Push};
pub use solver::Solver;
pub use speed_piece::SpeedPiece;
pub use timed::{Moment, Timed};
