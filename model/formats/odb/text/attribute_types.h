#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/diagnostics.h"
#include "model/formats/odb/text/job_tree.h"

namespace model::odb {

/// What the attributes of records mean. Records hold numbers (`;0=1,2` behind the fields); which number is an option, a
/// text of the file's `&` table or simply a number depends on the type of the attribute. Types come from
/// `misc/sysattr*` and `misc/userattr`; for jobs without these files the types of the common system attributes are
/// built in. Frozen after reading, so every thread may read it.
class AttributeTypes {
public:
    AttributeTypes();
    /// Reads all type files of the job.
    AttributeTypes(const formats::FileTree& job, Diagnostics& diagnostics);

    /// Blocks `BOOLEAN|OPTION|TEXT|INTEGER|FLOAT {NAME= OPTIONS=a;b}`; a later definition replaces an earlier one.
    void read(std::string_view text, std::string_view path, Diagnostics& diagnostics);

    /// The value in words. `raw` is what follows `=` in the record, empty when there is nothing: then the attribute is
    /// a boolean that is set, "yes". An option without a text, a text that the file does not list and the value of an
    /// attribute of unknown type stay as written.
    [[nodiscard]] std::string value(std::string_view name, std::string_view raw,
                                    std::span<const std::string> texts) const;

private:
    struct Type {
        bool isText = false;
        std::vector<std::string> options;
    };

    std::map<std::string, Type, std::less<>> m_types;
};

}  // namespace model::odb
