#include "model/formats/odb/text/attributes.h"

#include "model/formats/odb/text/records.h"

namespace model::odb {

AttributeList::AttributeList(std::string_view text, std::string_view path, Unit defaultUnit, Diagnostics& diagnostics)
    : m_block(parseStructured(text, path, diagnostics).top),
      m_unit(parseUnit(m_block.value("UNITS")).value_or(defaultUnit)) {}

std::optional<double> AttributeList::number(std::string_view name, std::string_view path,
                                            Diagnostics& diagnostics) const {
    const std::string_view value = text(name);
    if (value.empty()) {
        return std::nullopt;
    }
    const std::optional<double> number = parseReal(value);
    if (!number) {
        diagnostics.report(Severity::Warning, path, 0,
                           "attribute " + std::string(name) + " is not a number; it is ignored");
    }
    return number && *number != 0.0 ? number : std::nullopt;
}

}  // namespace model::odb
