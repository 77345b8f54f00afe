//! The options that matter to a plane mesh.

use super::Evaluator;
use super::value::Value;
use crate::geo::sources::Answer;
use crate::geo::syntax::{Assignment, Expression, Place};

/// What the script asks of the whole mesh.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::geo) struct Options {
    /// No target size is smaller (`Mesh.MeshSizeMin`).
    pub least_size: f64,
    /// No target size is larger (`Mesh.MeshSizeMax`).
    pub most_size: f64,
    /// All target sizes are multiplied by this (`Mesh.MeshSizeFactor`).
    pub size_factor: f64,
    /// Whether sizes at points count (`Mesh.MeshSizeFromPoints`).
    pub sizes_from_points: bool,
    /// Elements per whole turn of a curve (`Mesh.MeshSizeFromCurvature`); 0 where the script asks
    /// for none.
    pub elements_per_turn: f64,
    /// Whether what is the same is merged after every transformation (`Geometry.AutoCoherence`).
    pub auto_coherence: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            least_size: 0.0,
            most_size: 1e22,
            size_factor: 1.0,
            sizes_from_points: true,
            elements_per_turn: 0.0,
            auto_coherence: true,
        }
    }
}

/// The name of today for an option of old.
fn modern(name: &str) -> String {
    name.replace("CharacteristicLengthExtend", "MeshSizeExtend")
        .replace("CharacteristicLengthFrom", "MeshSizeFrom")
        .replace("CharacteristicLength", "MeshSize")
        .replace("MinimumElementsPerTwoPi", "MeshSizeFromCurvature")
}

impl Evaluator<'_, '_> {
    /// Sets an option, or passes over one that does not matter.
    pub(super) fn set_option(
        &mut self,
        place: Place,
        name: &str,
        operator: Assignment,
        value: &Expression,
    ) -> Answer<()> {
        let known = modern(name);
        let Some(old) = self.option(&known) else {
            self.skip(name, place);
            return Ok(());
        };
        let new = self.number(value)?;
        let new = match operator {
            Assignment::Set => new,
            operator => {
                self.changed(old, operator, new).map_err(|problem| problem.at(value.place))?
            }
        };
        match known.as_str() {
            "Mesh.MeshSizeMin" => self.options.least_size = new,
            "Mesh.MeshSizeMax" => self.options.most_size = new,
            "Mesh.MeshSizeFactor" => self.options.size_factor = new,
            "Mesh.MeshSizeFromPoints" => self.options.sizes_from_points = new != 0.0,
            "Mesh.MeshSizeFromCurvature" => self.options.elements_per_turn = new.max(0.0),
            "Geometry.AutoCoherence" => self.options.auto_coherence = new != 0.0,
            _ => self.model.tags.together = new != 0.0,
        }
        Ok(())
    }

    /// The value of an option that matters.
    fn option(&self, name: &str) -> Option<f64> {
        let flag = |is: bool| f64::from(u8::from(is));
        Some(match name {
            "Mesh.MeshSizeMin" => self.options.least_size,
            "Mesh.MeshSizeMax" => self.options.most_size,
            "Mesh.MeshSizeFactor" => self.options.size_factor,
            "Mesh.MeshSizeFromPoints" => flag(self.options.sizes_from_points),
            "Mesh.MeshSizeFromCurvature" => self.options.elements_per_turn,
            "Geometry.AutoCoherence" => flag(self.options.auto_coherence),
            "Geometry.OldNewReg" => flag(self.model.tags.together),
            _ => return None,
        })
    }

    /// The value of an option, for an expression.
    pub(super) fn option_value(&self, name: &str) -> Option<Value> {
        self.option(&modern(name)).map(Value::Number)
    }
}
