//! The syntax tree of a `.geo` script.
//!
//! Every node that an error may point at knows where it stands ([`Place`]).

use std::rc::Rc;

/// A place in one of the files of a script.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Place {
    /// The file, as the reader counts them.
    pub file: u32,
    /// The byte, counted from zero.
    pub offset: u32,
}

/// A statement and where it begins.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Statement {
    pub place: Place,
    pub action: Action,
}

/// Statements that belong together: the body of a loop, of a branch, of a macro.
pub(super) type Block = Rc<[Statement]>;

/// What a statement does.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Action {
    /// `a = 1;`, `a[] += {1, 2};`, `a[0]++;`
    Assign { target: Target, operator: Assignment, value: Expression },
    /// `Mesh.MeshSizeMax = 1;`
    Option { name: String, operator: Assignment, value: Expression },
    /// `DefineConstant[ a = 1, b = {2, Name "b"} ];`
    Define(Vec<Constant>),
    /// `Point(1) = {0, 0, 0};`, `Line Loop(1) = {1, 2, 3};`
    Entity { kind: EntityKind, tag: Expression, value: Expression },
    /// `Physical Curve("rim", 1) = {1, 2};`
    Physical {
        dim: u8,
        name: Option<Expression>,
        tag: Option<Expression>,
        operator: Assignment,
        members: Expression,
    },
    /// `MeshSize {1, 2} = 0.1;`
    Size { points: Expression, size: Expression },
    /// `Transfinite Curve {1, -2} = 10 Using Progression 1.2;`
    Transfinite { curves: Expression, points: Expression, law: Option<(Law, Expression)> },
    /// `Point {1} In Surface {2};`
    Embed { dim: u8, members: Expression, surfaces: Expression },
    /// A transformation, an extrusion: what can also stand on the right of an assignment.
    Command(Command),
    /// `Delete { Surface{1}; }`
    Delete { shapes: Shapes, recursive: bool },
    /// `Delete Physicals;`
    DeletePhysicals,
    /// `Coherence;`
    Coherence,
    /// `SetFactory("OpenCASCADE");`
    Factory(Expression),
    /// `If (a) … ElseIf (b) … Else … EndIf`
    If { branches: Vec<(Expression, Block)>, otherwise: Block },
    /// `For i In {1:3} … EndFor`; without a name `For (1:3) … EndFor`
    For {
        variable: Option<String>,
        first: Expression,
        last: Expression,
        step: Option<Expression>,
        body: Block,
    },
    /// `Macro Name … Return`
    Macro { name: String, body: Block },
    /// `Call Name;`
    Call(Expression),
    /// `Include "file.geo";` and `Merge "file.geo";`
    Include { name: Expression, merge: bool },
    /// `Error("…", a);` and `Abort;`: the script gives up.
    Fail(Option<Vec<Expression>>),
    /// `Exit;`
    Exit,
    /// A statement without effect on a plane mesh, by its name.
    Skipped(String),
    /// A statement that this reader does not know, by its name.
    Unsupported(String),
}

/// How an assignment changes what is there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Assignment {
    Set,
    Add,
    Subtract,
    Multiply,
    Divide,
}

/// What is assigned to.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Target {
    /// `a`
    Variable(Name),
    /// `a[]`, `a()`
    Whole(Name),
    /// `a[i]`, `a[{i, j}]`
    Elements(Name, Expression),
}

/// A name that may end in numbers that are computed: `x~{i}` is `x_3` where `i` is 3.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Name {
    pub place: Place,
    pub base: String,
    pub suffixes: Vec<Expression>,
}

/// A constant of `DefineConstant`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Constant {
    pub target: Target,
    /// Its value if it has none yet; without one it is 0.
    pub value: Option<Expression>,
}

/// What `Kind(tag) = {…};` makes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum EntityKind {
    Point,
    Line,
    Circle,
    Ellipse,
    Spline,
    BSpline,
    Bezier,
    CurveLoop,
    PlaneSurface,
    /// `Surface(1) = {…};`, `Ruled Surface(1) = {…};`: a patch between three or four curves.
    Patch,
    Rectangle,
    Disk,
    /// `Wire(1) = {…};`: a curve loop that may be open.
    Wire,
}

/// How points are spread along a transfinite curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Law {
    Progression,
    Bump,
}

/// An expression and where it begins.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Expression {
    pub place: Place,
    pub term: Term,
}

/// What an expression is.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Term {
    Number(f64),
    Text(String),
    /// A variable.
    Variable(Name),
    /// `a[]`, `a()`
    Whole(Name),
    /// `a[i]`, `a({i, j})`
    Elements(Name, Box<Expression>),
    /// `#a[]`
    Count(Name),
    /// `a++`, `a--` within an expression.
    Increment(Name, f64),
    /// `Mesh.MeshSizeMin`
    Option(String),
    /// `newp`, `newreg`, …
    Fresh(Fresh),
    Negative(Box<Expression>),
    Not(Box<Expression>),
    Binary(Operator, Box<[Expression; 2]>),
    /// `a ? b : c`
    Choice(Box<[Expression; 3]>),
    /// `a:b`, `a:b:step`
    Range(Box<[Expression; 2]>, Option<Box<Expression>>),
    /// `{1, 2, a[]}`
    List(Vec<Expression>),
    /// `Sin(x)`, `Sprintf("%g", x)`
    Call(Function, Vec<Expression>),
    /// `DefineNumber[1, Name "x"]`: the value, which nothing overrides here.
    Default(Box<Expression>),
    /// `Exists(a)`
    Exists(Name),
    /// `Surface{:}`, `Point "*"`
    All(u8),
    /// `Curve In BoundingBox{x0, y0, z0, x1, y1, z1}`
    InBox(u8, Box<Expression>),
    /// `Point{1}`: coordinates.
    Coordinates(Box<Expression>),
    /// `Physical Curve{1}`: what is in a group.
    Members(u8, Box<Expression>),
    /// `Translate {1, 0, 0} { Duplicata { Point{1}; } }`
    Command(Box<Command>),
}

/// The next number that is free.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fresh {
    Point,
    Curve,
    CurveLoop,
    Surface,
    /// `newv`, `newsl`, `newf`: of what a plane has none.
    Solid,
    Region,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Operator {
    Or,
    And,
    Equal,
    NotEqual,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Add,
    Subtract,
    Multiply,
    Divide,
    Remainder,
    Power,
}

/// A function of numbers, lists or texts, by its name in Gmsh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Function {
    Exp,
    Log,
    Log10,
    Sqrt,
    Sin,
    Asin,
    Cos,
    Acos,
    Tan,
    Atan,
    Atan2,
    Sinh,
    Cosh,
    Tanh,
    Abs,
    Floor,
    Ceil,
    Round,
    Sign,
    Step,
    Modulo,
    Hypot,
    Max,
    Min,
    Unique,
    LinSpace,
    LogSpace,
    Str,
    StrCat,
    Sprintf,
    StrPrefix,
    UpperCase,
    LowerCase,
    StrFind,
    StrCmp,
    StrLen,
    StrSub,
    StrReplace,
}

/// An operation on shapes; its value is the list of the shapes that it makes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Command {
    pub place: Place,
    pub operation: Operation,
    pub shapes: Shapes,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Operation {
    /// `Translate {x, y, z}`
    Translate(Expression),
    /// `Rotate {{axis}, {centre}, angle}`
    Rotate(Expression, Expression, Expression),
    /// `Symmetry {a, b, c, d}`: mirrors at the plane `ax + by + cz + d = 0`.
    Symmetry(Expression),
    /// `Dilate {{centre}, factor}`, `Dilate {{centre}, {factors}}`
    Dilate(Expression, Expression),
    /// `Duplicata`
    Duplicata,
    /// `Extrude {x, y, z}`
    ExtrudeAlong(Expression),
    /// `Extrude {{axis}, {point}, angle}`
    ExtrudeAround(Expression, Expression, Expression),
    /// `Boundary`, `CombinedBoundary`
    Boundary { combined: bool },
    /// `PointsOf`
    PointsOf,
    /// `BooleanDifference{ shapes }{ tools }`, `BooleanDifference(tag) = { shapes }{ tools }`
    Boolean { kind: BooleanKind, tag: Option<Expression>, tools: Shapes },
    /// An operation that is not read, by its name.
    Unsupported(String),
}

/// What a boolean operation keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum BooleanKind {
    /// Everything, as one.
    Union,
    /// What is in objects and in tools.
    Intersection,
    /// What is in objects and in no tool.
    Difference,
    /// Everything, cut where shapes meet.
    Fragments,
}

/// Shapes in braces.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Shapes {
    pub items: Vec<Shape>,
    /// `Layers{10};`: how many layers of elements an extrusion has.
    pub layers: Vec<Expression>,
    /// Whether `Delete;` stands among them.
    pub delete: bool,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    /// `Surface{1, 2};`
    Entities { dim: u8, tags: Expression },
    /// `Physical Surface{1};`
    Group { dim: u8, tags: Expression },
    /// `Duplicata { … }`
    Made(Box<Command>),
}
