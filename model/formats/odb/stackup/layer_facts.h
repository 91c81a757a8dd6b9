#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/board/document.h"
#include "model/formats/odb/stackup/matrix.h"
#include "model/formats/odb/text/job_tree.h"
#include "model/formats/odb/text/records.h"
#include "model/formats/odb/text/structured_text.h"

namespace model::odb {

/// The attributes of a job, step, layer or symbol: an `attrlist` file. Points into its text, path and diagnostics.
class AttributeList {
public:
    AttributeList(std::string_view text, std::string_view path, Unit defaultUnit, Diagnostics& diagnostics);

    [[nodiscard]] Unit unit() const { return m_unit; }
    /// The number of an attribute such as ".copper_weight", times `scale`; nothing when it is absent, empty or zero
    /// (zero means unset, odb-notes, Stack). A value that is no number is reported.
    [[nodiscard]] std::optional<double> number(std::string_view name, double scale = 1.0) const;
    /// The same, but a value beyond these bounds is a mistake of the writer, which is reported.
    [[nodiscard]] std::optional<double> numberWithin(std::string_view name, double least, double most) const;
    /// The thickness of what is printed or laid on: nothing, which is reported, where it is too thin or thick for
    /// `what`. Nanometres.
    [[nodiscard]] std::optional<double> thicknessWithin(std::string_view name, double least, double most,
                                                        const std::string& what) const;
    [[nodiscard]] std::string_view text(std::string_view name) const { return m_block.value(name); }
    /// "attribute NAME is WHAT; CONSEQUENCE", at the line of the attribute.
    void report(Severity severity, std::string_view name, std::string_view what,
                std::string_view consequence = "it is ignored") const;

private:
    Block m_block;
    Unit m_unit;
    std::string_view m_path;
    Diagnostics& m_diagnostics;
};

/// What the attributes of a layer say about its build (odb-notes, Stack). On copper .layer_dielectric and
/// .dielectric_constant are about the dielectric under it; .copper_weight is ounces per square foot in inch files and
/// µm in mm files, but for KiCad 10's, where they are ounces too, which is reported. On solder mask, silkscreen and
/// paste .layer_dielectric is their own thickness. Zero is "not set"; numbers that no material has are reported and
/// left out.
[[nodiscard]] LayerFacts factsOf(const AttributeList& attributes, const MatrixLayer& layer);

/// The .board_thickness of a file, in nm; nothing if there is no such file or it does not say.
[[nodiscard]] std::optional<double> boardThicknessIn(const formats::FileTree& tree, const std::string& path,
                                                     Unit defaultUnit, Diagnostics& diagnostics);

/// What the matrix says about the material of a layer.
void addMatrixFacts(const MatrixLayer& layer, Material& material);

}  // namespace model::odb
