//! A folder of its own for each test, and the command run in it.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A square with a region; its sides are walls (tag 1) and an outlet (tag 2).
pub const SQUARE: &str = "\
4 2 0 0
1 0 0
2 1 0
3 1 1
4 0 1
4 1
1 1 2 1
2 2 3 2
3 3 4 1
4 4 1 1
0
1
1 0.5 0.5 7 -1
";

/// Two diagonals of a square that cross in its middle.
pub const CROSSING: &str = "\
4 2 0 0
1 0 0
2 1 0
3 1 1
4 0 1
6 0
1 1 2
2 2 3
3 3 4
4 4 1
5 1 3
6 2 4
0
";

/// A square whose third corner has no y coordinate a reader could use.
pub const COMMA: &str = "4 2 0 0\n1 0 0\n2 1 0\n3 1.0 0,0\n4 0 1\n";

/// Two triangles over the unit square, counter-clockwise, all edges in one group.
pub const TWO: &str = "\
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 \"wall\"
2 2 \"water\"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
6
1 1 2 1 1 1 2
2 1 2 1 1 2 3
3 1 2 1 1 3 4
4 1 2 1 1 4 1
5 2 2 2 2 1 2 3
6 2 2 2 2 1 3 4
$EndElements
";

/// A folder for one test.
pub struct Bench {
    folder: PathBuf,
}

/// What a run of the command did.
#[derive(Debug)]
pub struct Ran {
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl Bench {
    /// An empty folder; `name` is the test's.
    pub fn new(name: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("command").join(name);
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder for the test");
        Self { folder }
    }

    /// A folder with a file in it.
    pub fn with(name: &str, file: &str, content: impl AsRef<[u8]>) -> Self {
        let bench = Self::new(name);
        bench.put(file, content);
        bench
    }

    pub fn put(&self, file: &str, content: impl AsRef<[u8]>) {
        fs::write(self.path(file), content).expect("a file for the test");
    }

    pub fn path(&self, file: &str) -> PathBuf {
        self.folder.join(file)
    }

    pub fn read(&self, file: &str) -> Vec<u8> {
        fs::read(self.path(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
    }

    /// The names in the folder, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.folder).expect("the test's folder");
        let name = |entry: std::io::Result<fs::DirEntry>| {
            entry.expect("an entry").file_name().to_string_lossy().into_owned()
        };
        let mut names: Vec<String> = entries.map(name).collect();
        names.sort();
        names
    }

    /// The command, to be run in the folder. Arguments are separated by spaces.
    pub fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_meshwright"));
        command.current_dir(&self.folder).args(arguments.split_whitespace());
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    pub fn run(&self, arguments: &str) -> Ran {
        Ran::from(self.command(arguments).output().expect("the command runs"))
    }

    /// Runs with something on stdin.
    pub fn run_with(&self, arguments: &str, stdin: &[u8]) -> Output {
        let mut child =
            self.command(arguments).stdin(Stdio::piped()).spawn().expect("the command runs");
        let written = child.stdin.take().expect("stdin is a pipe").write_all(stdin);
        let output = child.wait_with_output().expect("the command ends");
        written.expect("the command reads its stdin");
        output
    }

    /// Runs, and expects this exit code and nothing on stdout.
    pub fn fails(&self, arguments: &str, code: i32) -> String {
        let ran = self.run(arguments);
        assert_eq!(ran.code, Some(code), "{arguments}: {ran:?}");
        assert_eq!(ran.stdout, "", "{arguments}");
        ran.stderr
    }

    /// Runs, and expects success.
    pub fn succeeds(&self, arguments: &str) -> Ran {
        let ran = self.run(arguments);
        assert_eq!(ran.code, Some(0), "{arguments}: {ran:?}");
        ran
    }
}

impl From<Output> for Ran {
    fn from(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).expect("the command speaks UTF-8");
        Self {
            code: output.status.code(),
            stdout: text(output.stdout),
            stderr: text(output.stderr),
        }
    }
}
