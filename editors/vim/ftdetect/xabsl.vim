autocmd BufRead,BufNewFile *.xabsl setfiletype xabsl
