#include "model/formats/ipc2581/xml/xml_outline.h"

#include "model/base/limits.h"
#include "model/formats/ipc2581/xml/xml_cursor.h"

namespace model::ipc2581 {

namespace {

/// How many tags are read between two looks at whether the user wants to stop.
constexpr std::size_t kTagsPerLook = 1U << 14U;

void setFault(XmlOutline& outline, const XmlCursor& at, std::string_view what) {
    outline.fault = what;
    outline.faultLine = at.line();
    outline.text = outline.text.substr(0, at.offset());
    outline.hasDocumentType = what.find("DOCTYPE") != std::string_view::npos;
}

}  // namespace

XmlOutline outlineOf(std::string_view text, base::Progress& progress) {
    XmlOutline outline{text, {}, {}, 0, false};
    std::vector<std::string_view> open;
    XmlCursor at(text);
    for (std::size_t tags = 1; true; ++tags) {
        const XmlCursor::Token token = at.next();
        if (token == XmlCursor::Token::Finished) {
            return outline;
        }
        if (token == XmlCursor::Token::Broken) {
            setFault(outline, at, at.problem());
            return outline;
        }
        if (token == XmlCursor::Token::End) {
            if (open.back() != at.name()) {
                setFault(outline, at, "an end tag that does not fit its start tag");
                return outline;
            }
            open.pop_back();
            continue;
        }
        const int depth = static_cast<int>(open.size()) + 1;
        if (depth <= kOutlineDepth) {
            outline.sections.push_back({at.name(), at.offset(), at.line(), depth});
        }
        if (!at.isEmpty()) {
            if (open.size() == base::kMostXmlDepth) {
                static_assert(base::kMostXmlDepth == 64);
                setFault(outline, at, "elements nest too deep: 64 levels are the limit");
                return outline;
            }
            open.push_back(at.name());
        }
        if (tags % kTagsPerLook == 0) {
            progress.setFraction(static_cast<float>(at.offset()) / static_cast<float>(text.size()));
            if (progress.isCancelled()) {
                return outline;
            }
        }
    }
}

}  // namespace model::ipc2581
