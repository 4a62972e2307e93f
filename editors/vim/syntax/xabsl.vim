" XABSL 3.1
if exists("b:current_syntax")
  finish
endif
setlocal iskeyword+=.
syntax keyword xabslKeyword include option agent namespace behavior initial target state common decision action
syntax keyword xabslKeyword goto stay if else capacity synchronized
syntax keyword xabslType float bool enum const input output internal function
syntax keyword xabslConstant true false state_time option_time action_done conflict
syntax match xabslNumber /\<\d\+\(\.\d*\)\?\([eE][+-]\?\d\+\)\?/
syntax match xabslParameter /@\h[0-9A-Za-z_.]*/
syntax match xabslCall /\<\h[0-9A-Za-z_.]*\ze\s*(/
syntax match xabslRange /\[[^\]]*\]/
syntax region xabslString start=/"/ end=/"/ oneline
syntax match xabslComment /\/\/.*$/
syntax region xabslComment start=/\/\*/ end=/\*\//
syntax region xabslDoc start=/\/\*\*\/\@!/ end=/\*\//
highlight default link xabslKeyword Keyword
highlight default link xabslType Type
highlight default link xabslConstant Constant
highlight default link xabslNumber Number
highlight default link xabslParameter Identifier
highlight default link xabslCall Function
highlight default link xabslRange Special
highlight default link xabslString String
highlight default link xabslComment Comment
highlight default link xabslDoc SpecialComment
let b:current_syntax = "xabsl"
