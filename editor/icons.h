#pragma once
// Code points of the Fork Awesome icons in use, as UTF-8 text for labels; the theme bakes exactly these.

namespace pileus::editor::icon {

inline constexpr char kAdjust[] = "\xef\x81\x82";
inline constexpr char kArrowUp[] = "\xef\x81\xa2";
inline constexpr char kBan[] = "\xef\x81\x9e";
inline constexpr char kCamera[] = "\xef\x80\xb0";
inline constexpr char kCheck[] = "\xef\x80\x8c";
inline constexpr char kClock[] = "\xef\x80\x97";
inline constexpr char kCloud[] = "\xef\x83\x82";
inline constexpr char kCrosshairs[] = "\xef\x81\x9b";
inline constexpr char kCube[] = "\xef\x86\xb2";
inline constexpr char kDesktop[] = "\xef\x84\x88";
inline constexpr char kError[] = "\xef\x81\xaa";
inline constexpr char kExpand[] = "\xef\x81\xa5";
inline constexpr char kFile[] = "\xef\x80\x96";
inline constexpr char kFolder[] = "\xef\x81\xbb";
inline constexpr char kFolderOpen[] = "\xef\x81\xbc";
inline constexpr char kHome[] = "\xef\x80\x95";
inline constexpr char kInfo[] = "\xef\x81\x9a";
inline constexpr char kList[] = "\xef\x80\xba";
inline constexpr char kMath[] = "\xef\x87\xac";
inline constexpr char kPause[] = "\xef\x81\x8c";
inline constexpr char kPicture[] = "\xef\x80\xbe";
inline constexpr char kRefresh[] = "\xef\x80\xa1";
inline constexpr char kSearch[] = "\xef\x80\x82";
inline constexpr char kSliders[] = "\xef\x87\x9e";
inline constexpr char kSun[] = "\xef\x86\x85";
inline constexpr char kTimes[] = "\xef\x80\x8d";
inline constexpr char kUndo[] = "\xef\x83\xa2";
inline constexpr char kWarning[] = "\xef\x81\xb1";

}  // namespace pileus::editor::icon
