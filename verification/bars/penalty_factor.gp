# gnuplot -c penalty_factor.gp FOLDER: the penalty factor over the distance, from penalty_factor.csv
folder = ARG1
set terminal svg size 720,420 font "sans,13" background rgb "white"
set output folder."/penalty_factor.svg"
set datafile separator ","
set key outside right top samplen 2
set xlabel "s / d"
set ylabel "f_p"
set yrange [-0.05:1.1]
set grid lc rgb "#dddddd"
plot for [i=2:6] folder."/penalty_factor.csv" using 1:i with lines lw 2 \
    lc rgb word("#0072B2 #56B4E9 #009E73 #D55E00 #CC79A7", i - 1) \
    title "k = ".word("1 2 4 6 10", i - 1)
