#pragma once

#include <vector>

#include "model/board/document_builder.h"
#include "model/formats/odb/layer_table.h"

/// Where layers exist: all over the board, within a profile of their own, or in some of the board's zones.
namespace model::odb {

/// The layers of the zones of a file.
struct ZoneRows {
    std::vector<std::vector<std::size_t>> rows;  ///< by zone: rows of Matrix::layers, rising, each once
    std::vector<std::uint32_t> unknown;          ///< lines of zones that name a layer the matrix does not have
    bool hasNumbers = false;
    bool countsFromZero = false;  ///< number n is ROW n + 1 of the matrix, not ROW n
};

/// The numbers of LYR records count the rows of the matrix, and jobs differ in whether they begin with 0 or with 1: the
/// reading holds under which more of them are layers of the stackup, or else more copper is in a zone, from 0 in doubt
/// (odb-notes, Rigid-flex).
[[nodiscard]] ZoneRows rowsOfZones(const ZoneFile& file, const Matrix& matrix);

/// Layer::outlineGroup for every row of Matrix::layers, from what all steps say.
[[nodiscard]] std::vector<std::uint32_t> outlineGroups(const Steps& steps, const Matrix& matrix);

/// Adds the zones of a step to its document and gives layers their outlines: their own profile, or else, of layers that
/// some but not all zones have, what those zones cover together. To be called once the board has its profile.
void addOutlines(DocumentBuilder& builder, const Matrix& matrix, const LayerTable& layers, const StepData& step);

}  // namespace model::odb
