#include <cassert>
#include <cmath>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "core/formats/eaf.h"
#include "core/formats/json_text.h"

namespace kumite {
namespace {

int milliseconds(double seconds) {
    return static_cast<int>(std::lround(1000 * seconds));
}

/// Text that XML may hold: UTF-8 without control characters.
std::string printable(const std::string& text) {
    std::string out = asStored(text);
    for (char& c : out) {
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    return out;
}

void set(pugi::xml_node node, const char* name, const std::string& value) {
    node.append_attribute(name).set_value(value.c_str());
}

class EafWriter {
public:
    explicit EafWriter(const EafDocument& document) : document_(document) {}

    std::string text() {
        pugi::xml_node declaration = xml_.append_child(pugi::node_declaration);
        set(declaration, "version", "1.0");
        set(declaration, "encoding", "UTF-8");
        root_ = xml_.append_child("ANNOTATION_DOCUMENT");
        set(root_, "AUTHOR", "");
        set(root_, "DATE", "2000-01-01T00:00:00+00:00");  // equal labels give equal files
        set(root_, "FORMAT", "3.0");
        set(root_, "VERSION", "3.0");
        set(root_, "xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance");
        set(root_, "xsi:noNamespaceSchemaLocation", "http://www.mpi.nl/tools/elan/EAFv3.0.xsd");
        header();
        timeOrder();
        for (const EafTier& each : document_.tiers)
            tier(each);
        lastId_.text().set(annotations_);
        types();
        vocabularies();
        std::ostringstream out;
        xml_.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
        return out.str();
    }

private:
    void header() {
        pugi::xml_node header = root_.append_child("HEADER");
        set(header, "MEDIA_FILE", "");
        set(header, "TIME_UNITS", "milliseconds");
        lastId_ = header.append_child("PROPERTY");
        set(lastId_, "NAME", "lastUsedAnnotationId");
    }

    void timeOrder() {
        for (const EafTier& tier : document_.tiers) {
            if (!tier.parent.empty()) continue;
            for (const EafAnnotation& annotation : tier.annotations) {
                slots_[milliseconds(annotation.begin)];
                slots_[milliseconds(annotation.end)];
            }
        }
        pugi::xml_node order = root_.append_child("TIME_ORDER");
        int number = 0;
        for (auto& [time, name] : slots_) {
            name = fmt::format("ts{}", ++number);
            pugi::xml_node slot = order.append_child("TIME_SLOT");
            set(slot, "TIME_SLOT_ID", name);
            set(slot, "TIME_VALUE", std::to_string(time));
        }
    }

    void tier(const EafTier& tier) {
        pugi::xml_node node = root_.append_child("TIER");
        set(node, "LINGUISTIC_TYPE_REF", typeOf(tier));
        if (!tier.parent.empty()) set(node, "PARENT_REF", printable(tier.parent));
        if (!tier.participant.empty()) set(node, "PARTICIPANT", printable(tier.participant));
        set(node, "TIER_ID", printable(tier.id));
        for (const EafAnnotation& each : tier.annotations) {
            const std::pair span(milliseconds(each.begin), milliseconds(each.end));
            pugi::xml_node outer = node.append_child("ANNOTATION");
            const std::string id = fmt::format("a{}", ++annotations_);
            pugi::xml_node annotation;
            if (tier.parent.empty()) {
                annotation = outer.append_child("ALIGNABLE_ANNOTATION");
                set(annotation, "ANNOTATION_ID", id);
                set(annotation, "TIME_SLOT_REF1", slots_.at(span.first));
                set(annotation, "TIME_SLOT_REF2", slots_.at(span.second));
                placed_[tier.id][span] = id;
            } else {
                annotation = outer.append_child("REF_ANNOTATION");
                set(annotation, "ANNOTATION_ID", id);
                assert(placed_[tier.parent].contains(span));
                set(annotation, "ANNOTATION_REF", placed_[tier.parent][span]);
            }
            if (const std::string entry = entryOf(tier.vocabulary, each.value); !entry.empty()) {
                set(annotation, "CVE_REF", entry);
            }
            annotation.append_child("ANNOTATION_VALUE").text().set(printable(each.value).c_str());
        }
    }

    static std::string typeOf(const EafTier& tier) {
        return tier.vocabulary.empty() ? "annotation" : printable(tier.vocabulary);
    }

    /// The id of a controlled vocabulary's entry; empty where the value is none of its words.
    std::string entryOf(const std::string& vocabulary, const std::string& value) const {
        for (std::size_t v = 0; v < document_.vocabularies.size(); ++v) {
            if (document_.vocabularies[v].id != vocabulary) continue;
            const auto& entries = document_.vocabularies[v].entries;
            for (std::size_t e = 0; e < entries.size(); ++e) {
                if (entries[e].first == value) return entryId(v, e);
            }
        }
        return {};
    }
    static std::string entryId(std::size_t vocabulary, std::size_t entry) {
        return fmt::format("cveid{}_{}", vocabulary, entry);
    }

    void types() {
        std::map<std::string, const EafTier*> types;
        for (const EafTier& tier : document_.tiers)
            types.emplace(typeOf(tier), &tier);
        for (const auto& [name, tier] : types) {
            pugi::xml_node type = root_.append_child("LINGUISTIC_TYPE");
            if (!tier->parent.empty()) set(type, "CONSTRAINTS", "Symbolic_Association");
            if (!tier->vocabulary.empty()) {
                set(type, "CONTROLLED_VOCABULARY_REF", printable(tier->vocabulary));
            }
            set(type, "GRAPHIC_REFERENCES", "false");
            set(type, "LINGUISTIC_TYPE_ID", name);
            set(type, "TIME_ALIGNABLE", tier->parent.empty() ? "true" : "false");
        }
    }

    void vocabularies() {
        pugi::xml_node language = root_.append_child("LANGUAGE");
        set(language, "LANG_DEF", "http://cdb.iso.org/lg/CDB-00130975-001");
        set(language, "LANG_ID", "und");
        set(language, "LANG_LABEL", "undetermined (und)");
        const std::pair<const char*, const char*> constraints[] = {
            {"Time_Subdivision", "Parts of the parent annotation, without gaps"},
            {"Symbolic_Subdivision", "Ordered parts of the parent annotation, without times"},
            {"Symbolic_Association", "One annotation for one of the parent tier"},
            {"Included_In", "Within the parent annotation's time, gaps are allowed"}};
        for (const auto& [name, description] : constraints) {
            pugi::xml_node constraint = root_.append_child("CONSTRAINT");
            set(constraint, "DESCRIPTION", description);
            set(constraint, "STEREOTYPE", name);
        }
        for (std::size_t v = 0; v < document_.vocabularies.size(); ++v) {
            const EafVocabulary& vocabulary = document_.vocabularies[v];
            pugi::xml_node node = root_.append_child("CONTROLLED_VOCABULARY");
            set(node, "CV_ID", printable(vocabulary.id));
            set(node.append_child("DESCRIPTION"), "LANG_REF", "und");
            for (std::size_t e = 0; e < vocabulary.entries.size(); ++e) {
                pugi::xml_node entry = node.append_child("CV_ENTRY_ML");
                set(entry, "CVE_ID", entryId(v, e));
                pugi::xml_node value = entry.append_child("CVE_VALUE");
                set(value, "DESCRIPTION", printable(vocabulary.entries[e].second));
                set(value, "LANG_REF", "und");
                value.text().set(printable(vocabulary.entries[e].first).c_str());
            }
        }
    }

    const EafDocument& document_;
    pugi::xml_document xml_;
    pugi::xml_node root_, lastId_;
    std::map<int, std::string> slots_;  ///< milliseconds to the slot's id
    /// Ids of aligned annotations by tier, begin and end.
    std::map<std::string, std::map<std::pair<int, int>, std::string>> placed_;
    int annotations_ = 0;
};

}  // namespace

std::string eafText(const EafDocument& document) {
    return EafWriter(document).text();
}

}  // namespace kumite
