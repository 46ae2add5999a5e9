#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/formats/eaf.h"

namespace kumite {
namespace {

/// An annotation before its time is known.
struct Raw {
    std::size_t tier = 0;
    std::string id;
    std::string beginSlot, endSlot;  ///< of an aligned annotation
    std::string parent, previous;    ///< of a dependent one
    std::optional<double> begin = std::nullopt, end = std::nullopt;
    std::string value;
    int line = 0;

    bool timed() const { return begin && end; }
};

class EafReader {
public:
    EafReader(std::string_view text, const std::string& file, Findings* findings)
        : text_(text), file_(file), findings_(findings) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '\n') lineEnds_.push_back(i);
        }
    }

    EafDocument read() {
        const pugi::xml_node root = open();
        readVocabularies(root);
        readSlots(root);
        for (const pugi::xml_node tier : root.children("TIER"))
            readTier(tier);
        timeAligned();
        timeDependent();
        handOver();
        return std::move(document_);
    }

private:
    int lineAt(std::ptrdiff_t offset) const {
        const auto before =
            std::lower_bound(lineEnds_.begin(), lineEnds_.end(),
                             static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, offset)));
        return static_cast<int>(before - lineEnds_.begin()) + 1;
    }
    int lineOf(pugi::xml_node node) const { return lineAt(node.offset_debug()); }
    InputError error(int line, const std::string& sentence) const {
        return InputError(file_, line, 0, sentence);
    }
    /// An attribute that must be there.
    std::string required(pugi::xml_node node, const char* name) const {
        const pugi::xml_attribute attribute = node.attribute(name);
        if (!attribute || *attribute.value() == '\0') {
            throw error(lineOf(node), fmt::format("{} has no {}.", node.name(), name));
        }
        return attribute.value();
    }

    pugi::xml_node open() {
        if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF")) {
            throw error(0, "is UTF-16; ELAN documents are UTF-8.");
        }
        if (const auto zero = text_.find('\0'); zero != std::string_view::npos) {
            throw error(lineAt(static_cast<std::ptrdiff_t>(zero)), "a zero byte is no text.");
        }
        const pugi::xml_parse_result result =
            xml_.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
        if (!result) {
            std::string what = result.description();
            if (!what.empty()) what[0] = static_cast<char>(std::tolower(what[0]));
            throw error(lineAt(result.offset), fmt::format("is no XML: {}.", what));
        }
        const pugi::xml_node root = xml_.document_element();
        if (std::string_view(root.name()) != "ANNOTATION_DOCUMENT") {
            throw error(lineOf(root), fmt::format("is no ELAN document: expected "
                                                  "ANNOTATION_DOCUMENT, found {}.",
                                                  root.name()));
        }
        return root;
    }

    void readVocabularies(pugi::xml_node root) {
        for (const pugi::xml_node each : root.children("CONTROLLED_VOCABULARY")) {
            EafVocabulary vocabulary{required(each, "CV_ID"), {}};
            for (const pugi::xml_node entry : each.children("CV_ENTRY_ML")) {
                const pugi::xml_node value = entry.child("CVE_VALUE");
                vocabulary.entries.emplace_back(trimmed(value.text().get()),
                                                value.attribute("DESCRIPTION").value());
                entries_[{vocabulary.id, entry.attribute("CVE_ID").value()}] =
                    vocabulary.entries.back().first;
            }
            for (const pugi::xml_node entry : each.children("CV_ENTRY")) {  // before EAF 2.8
                vocabulary.entries.emplace_back(trimmed(entry.text().get()),
                                                entry.attribute("DESCRIPTION").value());
            }
            document_.vocabularies.push_back(std::move(vocabulary));
        }
        for (const pugi::xml_node type : root.children("LINGUISTIC_TYPE")) {
            typeVocabulary_[type.attribute("LINGUISTIC_TYPE_ID").value()] =
                type.attribute("CONTROLLED_VOCABULARY_REF").value();
        }
    }

    void readSlots(pugi::xml_node root) {
        const pugi::xml_node header = root.child("HEADER");
        const std::string units = header.attribute("TIME_UNITS").as_string("milliseconds");
        const std::map<std::string, double> known = {
            {"milliseconds", 1e-3}, {"PAL-frames", 1.0 / 25}, {"NTSC-frames", 1001.0 / 30000}};
        const auto unit = known.find(units);
        if (unit == known.end()) {
            throw error(lineOf(header), fmt::format("TIME_UNITS \"{}\" is not known.", units));
        }
        for (const pugi::xml_node slot : root.child("TIME_ORDER").children("TIME_SLOT")) {
            std::optional<double> time;
            if (const pugi::xml_attribute value = slot.attribute("TIME_VALUE")) {
                time = parseNumber(trimmed(value.value()));
                if (!time || *time < 0) {
                    throw error(lineOf(slot),
                                fmt::format("TIME_VALUE \"{}\" is no time.", value.value()));
                }
                *time *= unit->second;
            }
            if (!slots_.emplace(required(slot, "TIME_SLOT_ID"), time).second) {
                throw error(lineOf(slot), fmt::format("there are two time slots \"{}\".",
                                                      slot.attribute("TIME_SLOT_ID").value()));
            }
        }
    }

    void readTier(pugi::xml_node node) {
        EafTier tier;
        tier.id = trimmed(required(node, "TIER_ID"));
        tier.participant = trimmed(node.attribute("PARTICIPANT").value());
        tier.parent = node.attribute("PARENT_REF").value();
        tier.vocabulary = typeVocabulary_[node.attribute("LINGUISTIC_TYPE_REF").value()];
        tier.line = lineOf(node);
        for (const pugi::xml_node annotation : node.children("ANNOTATION")) {
            for (const pugi::xml_node each : annotation.children())
                readAnnotation(each, tier.vocabulary);
        }
        document_.tiers.push_back(std::move(tier));
    }

    void readAnnotation(pugi::xml_node node, const std::string& vocabulary) {
        Raw raw;
        raw.tier = document_.tiers.size();
        raw.line = lineOf(node);
        const std::string_view kind = node.name();
        if (kind == "ALIGNABLE_ANNOTATION") {
            raw.beginSlot = required(node, "TIME_SLOT_REF1");
            raw.endSlot = required(node, "TIME_SLOT_REF2");
            raw.begin = slotTime(raw.beginSlot, raw.line);
            raw.end = slotTime(raw.endSlot, raw.line);
            if (raw.timed() && *raw.end < *raw.begin) {
                throw error(raw.line, "the annotation ends before it begins.");
            }
        } else if (kind == "REF_ANNOTATION") {
            raw.parent = required(node, "ANNOTATION_REF");
            raw.previous = node.attribute("PREVIOUS_ANNOTATION").value();
        } else {
            throw error(raw.line, fmt::format("{} is no annotation.", kind));
        }
        raw.id = required(node, "ANNOTATION_ID");
        raw.value = trimmed(node.child("ANNOTATION_VALUE").text().get());
        if (raw.value.empty()) {
            const auto entry = entries_.find({vocabulary, node.attribute("CVE_REF").value()});
            if (entry != entries_.end()) raw.value = entry->second;
        }
        if (!byId_.emplace(raw.id, raws_.size()).second) {
            throw error(raw.line, fmt::format("there are two annotations \"{}\".", raw.id));
        }
        raws_.push_back(std::move(raw));
    }

    std::optional<double> slotTime(const std::string& id, int line) const {
        const auto slot = slots_.find(id);
        if (slot == slots_.end()) {
            throw error(line, fmt::format("there is no time slot \"{}\".", id));
        }
        return slot->second;
    }

    /// Chains of aligned annotations whose inner slots have no time share it evenly.
    void timeAligned() {
        std::map<std::pair<std::size_t, std::string>, std::size_t> byBegin;
        for (std::size_t i = 0; i < raws_.size(); ++i) {
            if (raws_[i].parent.empty())
                byBegin.emplace(std::pair(raws_[i].tier, raws_[i].beginSlot), i);
        }
        for (std::size_t i = 0; i < raws_.size(); ++i) {
            if (!raws_[i].begin || raws_[i].end || !raws_[i].parent.empty()) continue;
            std::vector<std::size_t> chain = {i};
            while (!raws_[chain.back()].end) {
                const auto next = byBegin.find({raws_[i].tier, raws_[chain.back()].endSlot});
                if (next == byBegin.end() || raws_[next->second].begin) break;
                chain.push_back(next->second);
                if (chain.size() > raws_.size()) break;  // it bites its tail
            }
            if (raws_[chain.back()].end) share(chain, *raws_[i].begin, *raws_[chain.back()].end);
        }
    }

    void share(const std::vector<std::size_t>& among, double begin, double end) {
        const double step = (end - begin) / static_cast<double>(among.size());
        for (std::size_t i = 0; i < among.size(); ++i) {
            raws_[among[i]].begin = begin + step * static_cast<double>(i);
            raws_[among[i]].end =
                i + 1 == among.size() ? end : begin + step * static_cast<double>(i + 1);
        }
    }

    /// From the aligned ones outward: what refers to an annotation shares its time, per tier.
    void timeDependent() {
        std::map<std::size_t, std::map<std::size_t, std::vector<std::size_t>>> children;
        for (std::size_t i = 0; i < raws_.size(); ++i) {
            if (raws_[i].parent.empty()) continue;
            const auto parent = byId_.find(raws_[i].parent);
            if (parent == byId_.end()) {
                throw error(raws_[i].line,
                            fmt::format("there is no annotation \"{}\".", raws_[i].parent));
            }
            children[parent->second][raws_[i].tier].push_back(i);
        }
        std::vector<std::size_t> open;
        std::vector<bool> reached(raws_.size(), false);
        for (std::size_t i = 0; i < raws_.size(); ++i) {
            if (raws_[i].parent.empty()) open.push_back(i);
        }
        while (!open.empty()) {
            const std::size_t parent = open.back();
            open.pop_back();
            reached[parent] = true;
            for (auto& [tier, those] : children[parent]) {
                putInOrder(those);
                if (raws_[parent].timed()) share(those, *raws_[parent].begin, *raws_[parent].end);
                open.insert(open.end(), those.begin(), those.end());
            }
        }
        const auto lost = std::find(reached.begin(), reached.end(), false);
        if (lost == reached.end()) return;
        throw error(raws_[static_cast<std::size_t>(lost - reached.begin())].line,
                    "the annotation refers to itself in the end.");
    }

    /// By who says to follow whom; what follows nobody keeps its place in the file.
    void putInOrder(std::vector<std::size_t>& siblings) const {
        std::map<std::string, std::size_t> follower;
        std::vector<std::size_t> ordered;
        for (const std::size_t each : siblings) {
            const bool first = raws_[each].previous.empty() ||
                               !follower.emplace(raws_[each].previous, each).second;
            if (first) ordered.push_back(each);
        }
        std::vector<std::size_t> result;
        for (std::size_t each : ordered) {
            result.push_back(each);
            for (auto next = follower.find(raws_[each].id); next != follower.end();
                 next = follower.find(raws_[each].id)) {
                each = next->second;
                follower.erase(next);
                result.push_back(each);
            }
        }
        std::vector<std::size_t> rest;  // those that follow somebody elsewhere, or each other
        for (const auto& [id, each] : follower)
            rest.push_back(each);
        std::sort(rest.begin(), rest.end());
        result.insert(result.end(), rest.begin(), rest.end());
        siblings = std::move(result);
    }

    void handOver() {
        for (Raw& raw : raws_) {
            if (raw.timed()) {
                document_.tiers[raw.tier].annotations.push_back(
                    {*raw.begin, *raw.end, std::move(raw.value), raw.line});
            } else if (findings_) {
                findings_->push_back(
                    warning(fmt::format("{}:{}: the annotation \"{}\" has no time and is left out.",
                                        file_, raw.line, raw.value)));
            }
        }
        for (EafTier& tier : document_.tiers) {
            std::stable_sort(
                tier.annotations.begin(), tier.annotations.end(),
                [](const EafAnnotation& a, const EafAnnotation& b) { return a.begin < b.begin; });
        }
    }

    std::string_view text_;
    const std::string& file_;
    Findings* findings_;
    std::vector<std::size_t> lineEnds_;
    pugi::xml_document xml_;
    EafDocument document_;
    /// Of controlled vocabularies, by the vocabulary's and the entry's id.
    std::map<std::pair<std::string, std::string>, std::string> entries_;
    std::map<std::string, std::string> typeVocabulary_;  ///< of a linguistic type
    std::map<std::string, std::optional<double>> slots_;
    std::vector<Raw> raws_;
    std::map<std::string, std::size_t> byId_;
};

}  // namespace

EafDocument parseEaf(std::string_view text, const std::string& file, Findings* findings) {
    return EafReader(text, file, findings).read();
}

}  // namespace kumite
