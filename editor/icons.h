#pragma once
// Code points of the Fork Awesome icons in use, as UTF-8 text for labels; the theme bakes exactly these.

namespace pileus::editor::icon {

inline constexpr char kAdjust[] = "\xef\x81\x82";
inline constexpr char kArrowLeft[] = "\xef\x81\xa0";
inline constexpr char kArrowRight[] = "\xef\x81\xa1";
inline constexpr char kArrowUp[] = "\xef\x81\xa2";
inline constexpr char kBan[] = "\xef\x81\x9e";
inline constexpr char kBell[] = "\xef\x83\xb3";
inline constexpr char kBookmark[] = "\xef\x80\xae";
inline constexpr char kCamera[] = "\xef\x80\xb0";
inline constexpr char kChart[] = "\xef\x88\x81";
inline constexpr char kCheck[] = "\xef\x80\x8c";
inline constexpr char kChevronRight[] = "\xef\x81\x94";
inline constexpr char kCircle[] = "\xef\x84\x91";
inline constexpr char kClock[] = "\xef\x80\x97";
inline constexpr char kClone[] = "\xef\x89\x8d";
inline constexpr char kCloud[] = "\xef\x83\x82";
inline constexpr char kColumns[] = "\xef\x83\x9b";
inline constexpr char kCompress[] = "\xef\x81\xa6";
inline constexpr char kCopy[] = "\xef\x83\x85";
inline constexpr char kCrosshairs[] = "\xef\x81\x9b";
inline constexpr char kCube[] = "\xef\x86\xb2";
inline constexpr char kCut[] = "\xef\x83\x84";
inline constexpr char kDesktop[] = "\xef\x84\x88";
inline constexpr char kEraser[] = "\xef\x84\xad";
inline constexpr char kError[] = "\xef\x81\xaa";
inline constexpr char kExpand[] = "\xef\x81\xa5";
inline constexpr char kEye[] = "\xef\x81\xae";
inline constexpr char kEyeSlash[] = "\xef\x81\xb0";
inline constexpr char kEyedropper[] = "\xef\x87\xbb";
inline constexpr char kFile[] = "\xef\x80\x96";
inline constexpr char kFilter[] = "\xef\x82\xb0";
inline constexpr char kFolder[] = "\xef\x81\xbb";
inline constexpr char kFolderOpen[] = "\xef\x81\xbc";
inline constexpr char kGroup[] = "\xef\x89\x87";
inline constexpr char kHistory[] = "\xef\x87\x9a";
inline constexpr char kHome[] = "\xef\x80\x95";
inline constexpr char kInfo[] = "\xef\x81\x9a";
inline constexpr char kKeyboard[] = "\xef\x84\x9c";
inline constexpr char kList[] = "\xef\x80\xba";
inline constexpr char kMath[] = "\xef\x87\xac";
inline constexpr char kMinus[] = "\xef\x81\xa8";
inline constexpr char kMoon[] = "\xef\x86\x86";
inline constexpr char kMore[] = "\xef\x85\x82";
inline constexpr char kPaint[] = "\xef\x87\xbc";
inline constexpr char kPaste[] = "\xef\x83\xaa";
inline constexpr char kPause[] = "\xef\x81\x8c";
inline constexpr char kPencil[] = "\xef\x81\x80";
inline constexpr char kPicture[] = "\xef\x80\xbe";
inline constexpr char kPin[] = "\xef\x82\x8d";
inline constexpr char kPlus[] = "\xef\x81\xa7";
inline constexpr char kPower[] = "\xef\x80\x91";
inline constexpr char kQuestion[] = "\xef\x81\x99";
inline constexpr char kRedo[] = "\xef\x80\x9e";
inline constexpr char kRefresh[] = "\xef\x80\xa1";
inline constexpr char kRuler[] = "\xef\x82\x80";
inline constexpr char kSave[] = "\xef\x83\x87";
inline constexpr char kSearch[] = "\xef\x80\x82";
inline constexpr char kShare[] = "\xef\x82\x8e";
inline constexpr char kSignIn[] = "\xef\x82\x90";
inline constexpr char kSignOut[] = "\xef\x82\x8b";
inline constexpr char kSliders[] = "\xef\x87\x9e";
inline constexpr char kSquare[] = "\xef\x82\x96";
inline constexpr char kSun[] = "\xef\x86\x85";
inline constexpr char kTerminal[] = "\xef\x84\xa0";
inline constexpr char kTimes[] = "\xef\x80\x8d";
inline constexpr char kTrash[] = "\xef\x87\xb8";
inline constexpr char kUndo[] = "\xef\x83\xa2";
inline constexpr char kUngroup[] = "\xef\x89\x88";
inline constexpr char kUnlink[] = "\xef\x84\xa7";
inline constexpr char kWarning[] = "\xef\x81\xb1";

}  // namespace pileus::editor::icon
