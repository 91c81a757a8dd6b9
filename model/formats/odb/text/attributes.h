#pragma once

#include <optional>
#include <string_view>

#include "model/board/diagnostics.h"
#include "model/formats/odb/text/lengths.h"
#include "model/formats/odb/text/structured_text.h"

namespace model::odb {

/// The attributes of a job, step, layer or symbol: an `attrlist` file. Views point into its text.
class AttributeList {
public:
    AttributeList() = default;
    AttributeList(std::string_view text, std::string_view path, Unit defaultUnit, Diagnostics& diagnostics);

    [[nodiscard]] Unit unit() const { return m_unit; }
    /// The number of an attribute such as ".copper_weight"; nothing when it is absent, empty or zero (zero means unset,
    /// odb-notes, Stack). A value that is no number is reported.
    [[nodiscard]] std::optional<double> number(std::string_view name, std::string_view path,
                                               Diagnostics& diagnostics) const;
    [[nodiscard]] std::string_view text(std::string_view name) const { return m_block.value(name); }

private:
    Block m_block;
    Unit m_unit = Unit::Inch;
};

}  // namespace model::odb
