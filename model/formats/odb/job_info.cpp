#include "model/formats/odb/job_info.h"

#include "model/formats/odb/text/records.h"
#include "model/formats/odb/text/structured_text.h"

namespace model::odb {

MiscInfo parseInfo(std::string_view text, std::string_view path, Diagnostics& diagnostics) {
    const StructuredText parsed = parseStructured(text, path, diagnostics);
    const auto value = [&](std::string_view key) { return toUtf8(parsed.top.value(key)); };
    MiscInfo info;
    info.jobName = value("JOB_NAME").empty() ? value("PRODUCT_MODEL_NAME") : value("JOB_NAME");
    info.generator = value("SAVE_APP").empty() ? value("ODB_SOURCE") : value("SAVE_APP");
    info.version = value("ODB_VERSION_MAJOR");
    if (!info.version.empty() && !value("ODB_VERSION_MINOR").empty()) {
        info.version += "." + value("ODB_VERSION_MINOR");
    }
    info.unit = parseUnit(value("UNITS"));
    return info;
}

}  // namespace model::odb
