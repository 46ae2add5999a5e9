#include "core/project/film_strip.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/motion/overlap.h"
#include "core/project/chart_svg.h"

namespace kumite {
namespace {

using Eigen::Vector3d;

constexpr double kMargin = 16, kTitle = 34, kRowTitle = 22, kCaption = 22, kGap = 8;

std::string at(double value) {
    return fixed(value, 1);
}

/// Where the eye is: pictures' axes in space.
struct Eye {
    Vector3d right = Vector3d::UnitX();
    Vector3d up = Vector3d::UnitY();
    Vector3d toward = Vector3d::UnitZ();  ///< from the picture to the eye
};

/// Horizontal direction that a row shows to the right.
Vector3d acrossOf(const FilmPicture& picture) {
    const auto poseOf = [](const FilmFigure& figure) -> const Pose& {
        return figure.clip->frames[static_cast<std::size_t>(figure.frame)];
    };
    if (picture.figures.size() > 1) {
        Vector3d way = poseOf(picture.figures[1]).root - poseOf(picture.figures[0]).root;
        way.y() = 0;
        if (way.norm() > 0.05) return way.normalized();
    }
    if (!picture.figures.empty()) {
        const FilmFigure& only = picture.figures[0];
        const double yaw = headingOf(*only.clip->rig, poseOf(only)).value_or(0);
        return {std::sin(yaw), 0, std::cos(yaw)};
    }
    return Vector3d::UnitX();
}

Eye eyeOf(const FilmRow& row, FilmView view) {
    Eye eye;
    if (!row.pictures.empty()) eye.right = acrossOf(row.pictures.front());
    eye.toward = eye.right.cross(Vector3d::UnitY());
    if (view == FilmView::ThreeQuarter) {
        const double round = 35 * std::numbers::pi / 180, above = 15 * std::numbers::pi / 180;
        const Vector3d right = std::cos(round) * eye.right - std::sin(round) * eye.toward;
        const Vector3d level = right.cross(Vector3d::UnitY());
        eye = {right, std::cos(above) * Vector3d::UnitY() - std::sin(above) * level,
               std::cos(above) * level + std::sin(above) * Vector3d::UnitY()};
    }
    return eye;
}

/// "#rrggbb" with each part times `factor`.
std::string shaded(const std::string& colour, double factor) {
    unsigned rgb[3] = {0x80, 0x80, 0x80};
    if (colour.size() == 7) std::sscanf(colour.c_str(), "#%2x%2x%2x", &rgb[0], &rgb[1], &rgb[2]);
    std::string result = "#";
    for (const unsigned part : rgb) {
        const double value = std::clamp(std::round(part * factor), 0.0, 255.0);
        result += fmt::format("{:02x}", static_cast<unsigned>(value));
    }
    return result;
}

/// A capsule ready to be drawn; metres in the picture's axes, from its centre on the floor.
struct Stroke {
    Vector3d a, b;  ///< right, up, toward the eye
    double radius = 0;
    std::string colour;
    double opacity = 1;
};

bool isLeft(Role role) {
    return mirrored(role) != role && roleName(role).starts_with("left");
}

std::vector<Stroke> strokesOf(const FilmFigure& figure) {
    std::vector<Stroke> strokes;
    const Rig& rig = *figure.clip->rig;
    JointFrames frames;
    jointFrames(rig, figure.clip->frames[static_cast<std::size_t>(figure.frame)], frames);
    const auto place = [&](int joint) { return frames.positions[static_cast<std::size_t>(joint)]; };
    const auto add = [&](const Vector3d& a, const Vector3d& b, double radius, bool dark) {
        strokes.push_back({a, b, radius, shaded(figure.colour, dark ? 0.72 : 1.0), figure.opacity});
    };
    for (const BodySolid& solid : bodySolids()) {
        const auto from = rig.roles[solid.from], to = rig.roles[solid.to];
        if (from && to) add(place(*from), place(*to), solid.radius, isLeft(solid.to));
    }
    if (rig.roles.has(Role::Neck) && rig.roles.has(Role::Head)) {
        const Vector3d neck = place(*rig.roles[Role::Neck]), head = place(*rig.roles[Role::Head]);
        add(head, head + (head - neck), kSkullRadius, false);
    }
    for (int joint = 1; strokes.empty() && joint < rig.jointCount(); ++joint)
        add(place(rig.joint(joint).parent), place(joint), 0.02, false);
    return strokes;
}

/// A picture's capsules in its axes, far ones first; and its marks.
struct Scene {
    std::vector<Stroke> strokes;
    std::vector<std::pair<Vector3d, std::string>> marks;
    double centre = 0;  ///< along the right axis
    double width = 0;
    double top = 0, bottom = 0;
    /// Along the up axis, of the floor below the figures: seen from above it is not 0.
    double ground = 0;
};

Scene sceneOf(const FilmPicture& picture, const Eye& eye, double floor) {
    Scene scene;
    double low = INFINITY, high = -INFINITY;
    const auto seen = [&](const Vector3d& p) -> Vector3d {
        const Vector3d over = p - Vector3d(0, floor, 0);
        return {over.dot(eye.right), over.dot(eye.up), over.dot(eye.toward)};
    };
    const auto widen = [&](double x, double radius) {
        low = std::min(low, x - radius);
        high = std::max(high, x + radius);
    };
    for (const FilmFigure& figure : picture.figures) {
        std::vector<Stroke> strokes = strokesOf(figure);
        for (Stroke& stroke : strokes) {
            stroke.a = seen(stroke.a);
            stroke.b = seen(stroke.b);
            widen(stroke.a.x(), stroke.radius);
            widen(stroke.b.x(), stroke.radius);
            for (const Vector3d& end : {stroke.a, stroke.b}) {
                scene.top = std::max(scene.top, end.y() + stroke.radius);
                scene.bottom = std::min(scene.bottom, end.y() - stroke.radius);
            }
        }
        scene.strokes.insert(scene.strokes.end(), strokes.begin(), strokes.end());
        Vector3d below = figure.clip->frames[static_cast<std::size_t>(figure.frame)].root;
        below.y() = floor;
        scene.ground += seen(below).y() / static_cast<double>(picture.figures.size());
    }
    for (const FilmMark& mark : picture.marks) {
        scene.marks.emplace_back(seen(mark.place), mark.colour);
        widen(scene.marks.back().first.x(), 0.05);
    }
    std::stable_sort(
        scene.strokes.begin(), scene.strokes.end(),
        [](const Stroke& p, const Stroke& q) { return p.a.z() + p.b.z() < q.a.z() + q.b.z(); });
    if (high >= low) {
        scene.centre = 0.5 * (low + high);
        scene.width = high - low;
    }
    return scene;
}

std::string drawn(const Scene& scene, double centreX, double floorY, double scale) {
    std::string svg;
    const auto x = [&](const Vector3d& p) { return at(centreX + scale * (p.x() - scene.centre)); };
    const auto y = [&](const Vector3d& p) { return at(floorY - scale * (p.y() - scene.ground)); };
    for (const Stroke& stroke : scene.strokes) {
        const double width = 2 * scale * stroke.radius;
        const std::string line = fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" ",
                                             x(stroke.a), y(stroke.a), x(stroke.b), y(stroke.b));
        svg += fmt::format(
            "<g stroke-linecap=\"round\"{}>{}stroke=\"{}\" stroke-width=\"{}\"/>{}"
            "stroke=\"{}\" stroke-width=\"{}\"/></g>\n",
            stroke.opacity < 1 ? " opacity=\"" + fixed(stroke.opacity, 2) + "\"" : "", line,
            shaded(stroke.colour, 0.55), at(width + 1.6), line, stroke.colour, at(width));
    }
    for (const auto& [place, colour] : scene.marks) {
        svg += fmt::format(
            "<circle cx=\"{}\" cy=\"{}\" r=\"5\" fill=\"none\" stroke=\"{}\" "
            "stroke-width=\"2\"/>\n",
            x(place), y(place), xmlText(colour));
    }
    return svg;
}

}  // namespace

std::string filmStripSvg(const std::string& title, const std::vector<FilmRow>& rows,
                         const FilmSettings& settings) {
    std::vector<std::vector<Scene>> scenes;
    double widest = 0.8, tallest = 1.8, deepest = 0.05;  // metres over and below the floor line
    std::size_t columns = 1;
    for (const FilmRow& row : rows) {
        const Eye eye = eyeOf(row, settings.view);
        scenes.emplace_back();
        for (const FilmPicture& picture : row.pictures) {
            scenes.back().push_back(sceneOf(picture, eye, settings.floor));
            const Scene& scene = scenes.back().back();
            widest = std::max(widest, scene.width);
            tallest = std::max(tallest, scene.top - scene.ground);
            deepest = std::max(deepest, scene.ground - scene.bottom);
        }
        columns = std::max(columns, row.pictures.size());
    }
    const double scale = settings.pixelsPerMetre;
    const double pictureWidth = scale * (widest + 0.2),
                 pictureHeight = scale * (tallest + deepest + 0.2);
    const double rowHeight = kRowTitle + pictureHeight + kCaption + kGap;
    const double width = 2 * kMargin + static_cast<double>(columns) * (pictureWidth + kGap) - kGap;
    const double height = kTitle + static_cast<double>(rows.size()) * rowHeight + kMargin;

    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"12\">\n<rect "
        "width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n<text x=\"{2}\" y=\"24\" "
        "font-size=\"15\">{3}</text>\n",
        at(width), at(height), at(kMargin), xmlText(title));
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const double top = kTitle + static_cast<double>(r) * rowHeight;
        if (!rows[r].title.empty()) {
            svg += fmt::format("<text x=\"{}\" y=\"{}\" fill=\"#555555\">{}</text>\n", at(kMargin),
                               at(top + 15), xmlText(rows[r].title));
        }
        for (std::size_t p = 0; p < scenes[r].size(); ++p) {
            const double left = kMargin + static_cast<double>(p) * (pictureWidth + kGap);
            const double floorY = top + kRowTitle + pictureHeight - scale * (deepest + 0.07);
            svg += fmt::format(
                "<g class=\"picture\">\n<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
                "fill=\"#f4f4f2\"/>\n",
                at(left), at(top + kRowTitle), at(pictureWidth), at(pictureHeight));
            if (settings.view == FilmView::Side) {
                svg += fmt::format(
                    "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" "
                    "stroke=\"#b8b8b4\"/>\n",
                    at(left), at(floorY), at(left + pictureWidth), at(floorY));
            }
            svg += drawn(scenes[r][p], left + pictureWidth / 2, floorY, scale) + "</g>\n";
            svg +=
                fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                            at(left + pictureWidth / 2), at(top + kRowTitle + pictureHeight + 15),
                            xmlText(rows[r].pictures[p].caption));
        }
    }
    return svg + "</svg>\n";
}

std::vector<int> evenFrames(FrameRange frames, int count) {
    std::vector<int> result;
    if (frames.empty()) return result;
    const int last = frames.size() - 1;
    for (int i = 0; i < count; ++i) {
        const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
        result.push_back(frames.begin + static_cast<int>(std::lround(share * last)));
    }
    return result;
}

}  // namespace kumite
